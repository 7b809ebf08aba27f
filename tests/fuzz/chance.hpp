#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fuzz {

/// Numbers from a seed, the same on every machine (splitmix64, Steele et al. 2014).
class Chance {
public:
    explicit Chance(std::uint64_t seed) : state_{seed} {}

    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }
    /// A number from 0 to `count` - 1; 0 for none. The remainder's bias does not matter here.
    std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(next() % count); }
    bool one_in(std::size_t count) { return below(count) == 0; }
    /// One of a list that is not empty.
    template <class List>
    const auto& any(const List& list) {
        return list[below(list.size())];
    }

private:
    std::uint64_t state_;
};

/// A seed for input `number` of a reader: of its own, so that each input can be repeated alone.
inline std::uint64_t seed_of(std::uint64_t seed, std::string_view reader, std::uint64_t number) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const char c : reader) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
    }
    Chance chance{seed ^ hash};
    return chance.next() + number * 0x9E3779B97F4A7C15ULL;
}

}  // namespace fuzz
