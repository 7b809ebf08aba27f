#pragma once

#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/start/starting_stand.hpp"

namespace coupling {

/// Crown cover of a square around a place [0, 1], the mean of the known cells at 10 x 10 points of it; NaN
/// where there is none.
double cover_around(const config::Raster<double>& cover, double x_m, double y_m, double side_m);

/// Gives the patches of each stand the crown cover of stands.cover, where the scenario names it: stems are
/// then placed in proportion to it. A patch of which the raster says nothing has the mean of its stand.
///
/// Refuses values that are neither percent nor shares, and stands with stems and without any cover. Warns of
/// stems that crowd on less than half of their stand.
void add_crown_cover(std::vector<forest::StandRecord>& inventory, const forest::PatchGrid& grid,
                     Reading& reading);

}  // namespace coupling
