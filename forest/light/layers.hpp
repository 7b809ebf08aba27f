#pragma once

#include <cstddef>

namespace forest {

/// Layers of the canopy, parallel to the ground.
inline constexpr std::size_t canopy_layers = 12;
inline constexpr double layer_height_m = 5.0;
inline constexpr double canopy_height_m = layer_height_m * static_cast<double>(canopy_layers);

}  // namespace forest
