#pragma once

#include <cstdint>

#include "config/grid/raster.hpp"

namespace coupling::hazard::zones {

/// Levels without zones that are smaller than asked for, unless they lie higher than what is around them.
///
/// A zone is a set of cells of one level that share sides. Zones of less area take the level with which they
/// share most of their border, of two the higher one, if it is higher than theirs; the smallest go first. So
/// holes are filled, no cell gets a lower level, and no area of a level vanishes but into a higher one. Cells
/// without a value (NaN) count as level 0.
config::Raster<std::uint8_t> without_small_zones(const config::Raster<float>& cells, double smallest_m2);

}  // namespace coupling::hazard::zones
