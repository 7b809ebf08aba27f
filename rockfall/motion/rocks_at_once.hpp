#pragma once

#include <cstdint>

#include "rockfall/motion/models.hpp"

namespace rockfall {

/// Rocks of a model that make some tenths of a second of work: a block takes a hundred times as long as a
/// sphere that only jumps.
constexpr std::uint32_t rocks_at_once(MotionModel model) {
    constexpr std::uint32_t blocks = 32;
    constexpr std::uint32_t spheres = 1024;
    return model == motion_model<rigid::Model> ? blocks : spheres;
}

}  // namespace rockfall
