#pragma once

#include <optional>
#include <span>
#include <vector>

#include "config/table/schema.hpp"
#include "coupling/inputs/observed/observed_stop.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// What a row of observed.stops says.
struct ObservedStopRow {
    double x_m = 0.0;
    double y_m = 0.0;
    config::Shape shape;
    std::optional<double> x_release_m;
    std::optional<double> y_release_m;
    std::optional<std::uint32_t> zone;
    std::string group;
};

/// With a shape in each row, or with coordinates.
config::Schema<ObservedStopRow> observed_stop_columns(bool by_shapes);

/// The table or layer observed.stops. Empty without that setting.
std::optional<std::vector<ObservedStop>> read_observed_stops(Reading& reading);

/// Refuses zones from which no rock starts, and stops of which most lie off the terrain; a few there are
/// doubtful. Nothing is left out.
void check_observed_stops(std::span<const ObservedStop> stops,
                          std::span<const rockfall::ReleaseSource> sources, const rockfall::Terrain& terrain,
                          Reading& reading);

}  // namespace coupling
