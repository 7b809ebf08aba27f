#pragma once

#include <cstdint>
#include <vector>

#include "config/geometry/shape.hpp"
#include "config/grid/raster.hpp"

namespace coupling::hazard::zones {

/// A zone as an area: closed rings by the even-odd rule, outer ones and holes.
struct ZoneOutline {
    std::uint8_t level = 0;
    double area_m2 = 0.0;  ///< of the smoothed area
    std::vector<std::vector<config::Point2>> rings;
};

/// The zones of all levels above 0, with smoothed outlines, in the order of their first cells.
///
/// Outlines run through the middles of the sides between cells of different levels, and their corners are cut
/// twice (Chaikin 1974). Neighbours share each piece of outline point by point, so there are neither gaps nor
/// overlaps, and the middle of each cell stays in the zone of its level. Corners where three or more zones
/// meet, and the border of the map, stay where they are. Where two cells of one level touch at a corner,
/// those of the higher level are one zone there.
std::vector<ZoneOutline> outlines_of(const config::Raster<std::uint8_t>& cells);

}  // namespace coupling::hazard::zones
