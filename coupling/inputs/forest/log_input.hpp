#pragma once

#include <optional>
#include <vector>

#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// Reads and checks the list of lying logs of the scenario; an empty list without one.
///
/// Columns species and either x1_m, y1_m, x2_m, y2_m or x_m, y_m, length_m, azimuth_deg (length in plan,
/// clockwise from north); dbh_cm, or diameter1_cm and diameter2_cm; perhaps log_id, clearance_m (0),
/// strength (1), anchored (no).
std::optional<std::vector<LogRecord>> read_logs(Reading& reading);

/// Drops logs of which an end does not lie on the terrain and says how many.
std::vector<LogRecord> on_terrain(std::vector<LogRecord> logs, const rockfall::Terrain& terrain,
                                  Reading& reading);

}  // namespace coupling
