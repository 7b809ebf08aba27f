#pragma once

#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/grid/raster.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Wider cells show no single crowns [choice].
inline constexpr double widest_canopy_cell_m = 2.0;

/// Refuses a raster that holds no heights of vegetation above the ground in metres, or in cells too wide for
/// crowns: throws InputError (data) with the likely cause and what to do. `projection`: what the file says of
/// its system.
void refuse_wrong_canopy(const config::Raster<double>& heights_m, const std::string& projection,
                         const std::string& file);

/// What may be wrong with a raster that is not refused; sentences as of a problem.
std::vector<config::Problem> warnings_of_canopy(const config::Raster<double>& heights_m,
                                                const std::string& file);

/// Takes heights that no tree has for unknown (birds, power lines, cliffs that two surveys place apart), and
/// fills holes of at most 4 m2 [choice], as a scan leaves where no ray fell (grids/filled_holes). Returns how
/// many holes were filled.
std::size_t clean_canopy(config::Raster<double>& heights_m);

/// The tree tops of trees.canopy as a list with x_m, y_m, height_m. Says on the first screen that the trees
/// below the crowns of others are missing, and which.
config::Table canopy_table(Reading& reading);

}  // namespace coupling
