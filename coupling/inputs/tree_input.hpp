#pragma once

#include <optional>
#include <vector>

#include "coupling/inputs/reading.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// Reads and checks the tree list of the scenario; an empty list without one.
///
/// Columns x_m, y_m, species, dbh_cm, height_m and perhaps tree_id; others are passed over. Species by code
/// or Latin name. Medians that look like another unit, identities used twice and species that borrow
/// parameters are told.
std::optional<std::vector<TreeRecord>> read_trees(Reading& reading);

/// Drops trees that do not stand on the terrain and tells how many.
std::vector<TreeRecord> on_terrain(std::vector<TreeRecord> trees, const rockfall::Terrain& terrain,
                                   Reading& reading);

}  // namespace coupling
