#pragma once

#include <optional>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/places/target_exposure.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/tally/target.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

const config::Schema<TargetRow>& target_list_columns();

/// Targets as their files give them, in absolute coordinates.
struct GivenTargets {
    std::vector<rockfall::Target> targets;
    std::vector<config::Place> places;  ///< where the shape of each stands
    std::vector<bool> is_exposed;       ///< whether columns say who or what is at it
};

/// Reads the targets of the scenario; none without any.
std::optional<GivenTargets> read_targets(Reading& reading);

/// The targets in coordinates of the terrain, with their bounds. Those that lie wholly beyond the terrain are
/// left out with one note, whatever their shapes are (plausible/beyond_terrain.hpp), and so are slivers with
/// a warning (plausible/odd_targets.hpp). Of those that lie partly on it a warning says so.
std::vector<rockfall::Target> on_terrain(GivenTargets given, const rockfall::Terrain& terrain,
                                         Reading& reading);

}  // namespace coupling
