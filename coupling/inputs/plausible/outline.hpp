#pragma once

#include <cstddef>

#include "config/grid/raster.hpp"

namespace coupling::plausible {

/// What the known cells of a grid go round.
struct Outline {
    double area_m2 = 0.0;  ///< between the cell centres inside, as a complete triangulation covers it
    double unknown = 0.0;  ///< share of the cells inside that are NaN [0, 1]
    std::size_t unknown_cells = 0;  ///< how many these are
};

/// Known cells (not NaN), the gaps between them that are too narrow to be a border, and what these enclose:
/// the morphological closing of the known cells with a square of 2 n + 1 cells, holes filled. n is twice the
/// mean distance between known cells, from the share of known ones among the 24 cells around each: 2 in a
/// whole grid, at most 40.
///
/// Turned by a right angle or mirrored, a grid has the same outline.
Outline outline_of(const config::Raster<double>& cells);

}  // namespace coupling::plausible
