#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/plausible/terrain/crowns.hpp"
#include "coupling/inputs/plausible/terrain/terrain_gate.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling::plausible {

/// Throws config::InputError (data) for heights below -500 or above 9000 m, which no mountain has, with the
/// likely cause: a NODATA value that the file does not declare, or another unit.
void check_height_range(double low_m, double high_m, const std::string& file);

/// That, slopes that no terrain has (half of the cells steeper than 80 degrees, as heights in centimetres or
/// cells in kilometres make them), and the errors of all rules on heights (`terrain/`). The rest of their
/// findings, which are warnings, come back. Requires at least one height that is known.
std::vector<terrain::Verdict> refuse_impossible_heights(const config::Raster<double>& grid,
                                                        const std::string& file);

/// That, and the warnings: of the rules, and of cells of 0 that stand for NODATA. Such cells amid known
/// ground are refused: rocks would end in them.
void check_grid_heights(const config::Raster<double>& grid, const std::string& file, Reading& reading);

/// The rules on heights over a terrain that is no grid: points, contours and meshes, read at the spacing of
/// their points. At least 3 x 3 known cells are looked at, else nothing.
void check_sampled_heights(const config::Raster<double>& samples, const std::string& file, Reading& reading);

/// Throws config::InputError where heights stand above Mont Blanc in a coordinate system of Europe: feet.
void check_highest_of_system(double high_m, const std::string& projection, const std::string& file);

/// All errors on a grid of heights at once, before anything is derived from it; nothing of a grid without a
/// known height.
void refuse_wrong_heights(const config::Raster<double>& grid, const std::string& projection,
                          const std::string& file);

/// The heights at the listed trees: an error or a warning where they stand on crowns. `heights` and `trees`
/// in the same coordinates.
void check_ground_at_trees(const config::Raster<double>& heights, std::span<const terrain::ListedTree> trees,
                           const std::string& file, Reading& reading);

/// Rocks that come to a hole are lost from the count behind it: warns of NODATA inside.
void doubt_holes(const config::Raster<double>& grid, const std::string& file, config::Effect effect,
                 Reading& reading);

}  // namespace coupling::plausible
