#pragma once

#include <cstddef>
#include <functional>

namespace rockfall::rock_mass {

/// Does work(0) ... work(count - 1), in any order and on any number of threads. This room starts no threads:
/// whoever has some hands over a function that uses them.
using ParallelFor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

/// One after the other.
inline void one_by_one(std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) {
        work(i);
    }
}

}  // namespace rockfall::rock_mass
