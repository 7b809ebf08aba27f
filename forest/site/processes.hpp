#pragma once

#include <cstdint>

namespace forest {

/// How light reaches the trees.
enum class TreeLight : std::uint8_t {
    in_space,   ///< by the light model (forest/light): every tree at its place
    by_layers,  ///< by layer_light(): every tree shades every other equally. For level ground without horizon
};

/// Which processes of a year run, beside those that always do. Deaths by age and by stress, browsing, wind,
/// snow and bark beetles are switched in the structs of their laws (forest/parameters.hpp).
struct Processes {
    bool water = true;  ///< soil water limits production and young trees; off: water is never short
    bool self_thinning = true;
    bool regeneration = true;
    bool co2_response = false;  ///< of quantum efficiency and conductance; off: as at 350 ppm
    TreeLight light = TreeLight::in_space;
};

}  // namespace forest
