#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/table/schema.hpp"
#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// What a row of a list of logs says; the log itself as far as its columns say it.
struct LogRow : rockfall::Log {
    std::string id;
    double length_m = 0.0;  ///< in plan
    double azimuth_deg = 0.0;
};

/// How a list of logs describes them.
struct LogForm {
    bool by_ends = true;  ///< two places; else one, length and azimuth
    bool one_diameter = true;
};

config::Schema<LogRow> log_columns(const LogForm& form);

/// Reads and checks the list of lying logs of the scenario; an empty list without one.
std::optional<std::vector<LogRecord>> read_logs(Reading& reading);

/// Drops logs of which an end does not lie on the terrain and says how many.
std::vector<LogRecord> on_terrain(std::vector<LogRecord> logs, const rockfall::Terrain& terrain,
                                  Reading& reading);

}  // namespace coupling
