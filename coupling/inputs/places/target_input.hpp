#pragma once

#include <optional>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/tally/target.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

struct TargetRow;
const config::Schema<TargetRow>& target_list_columns();

/// Reads the targets of the scenario in absolute coordinates; an empty list without any.
std::optional<std::vector<rockfall::Target>> read_targets(Reading& reading);

/// The targets in coordinates of the terrain, with their bounds. Those that lie wholly beyond the terrain are
/// left out with one note, see plausible/beyond_terrain.hpp; of those that lie partly on it a warning says
/// so.
std::vector<rockfall::Target> on_terrain(std::vector<rockfall::Target> targets,
                                         const rockfall::Terrain& terrain, Reading& reading);

}  // namespace coupling
