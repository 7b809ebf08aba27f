#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/systems/extent.hpp"

namespace coupling {

/// Ground heights of the user, as a new project needs to know them.
struct GivenHeights {
    std::string setting;  ///< of [terrain] that takes them: dem, points or mesh
    /// Where they have no cells: mean heights in cells of twice their spacing, to judge slopes by and to draw
    /// on.
    config::Raster<double> raster;
    bool has_grid = false;
    double spacing_m = 5.0;  ///< of the heights; of contours nobody knows
    std::string system;      ///< as well-known text, "" where none is named
    std::optional<plausible::Extent> extent{};
    std::optional<double> mean_height_m{};
    std::vector<std::string> remarks{};
};

/// Reads a grid, tiles, points, a mesh or contours. Throws InputError for what is none of them and for
/// heights that cannot be meant.
GivenHeights given_heights(const std::vector<std::string>& dem);

}  // namespace coupling
