#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coupling/inputs/observed/observed_stop.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// The table or layer observed.stops: `wkt` with a POINT, or `x_m` and `y_m`; perhaps `zone`, `group`,
/// `x_release_m` with `y_release_m`. Empty without that setting.
std::optional<std::vector<ObservedStop>> read_observed_stops(Reading& reading);

/// Refuses zones from which no rock starts, and stops of which most lie off the terrain; a few there are
/// doubtful. Nothing is left out.
void check_observed_stops(std::span<const ObservedStop> stops,
                          std::span<const rockfall::ReleaseSource> sources, const rockfall::Terrain& terrain,
                          Reading& reading);

}  // namespace coupling
