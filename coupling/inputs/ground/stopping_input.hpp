#pragma once

#include <map>
#include <string>

#include "config/table/declared.hpp"
#include "config/table/table.hpp"
#include "rockfall/laws/stopping.hpp"

namespace coupling {

/// How readily one ground type stops rocks, by their diameter.
struct StoppingCurves {
    rockfall::StopCurve stopping;             ///< probability at an impact [-]
    rockfall::StopCurve rolling_stops_per_m;  ///< rate while rolling [1/m]
    bool has_rolling = false;                 ///< the table has the column `rolling_stops_per_m`
    double smallest_m = 0.0;                  ///< diameters between which the table has values
    double largest_m = 0.0;
};

struct StoppingRow;
const config::Schema<StoppingRow>& stopping_columns(bool by_code);

/// The curves of a stopping table: columns `diameter_m`, `p_stop` and perhaps `rolling_stops_per_m`, rows in
/// any order, each diameter once for each ground type. `key` is the column that names the ground type:
/// `name`, or `code` with whole numbers. What is wrong joins `problems`.
std::map<std::string, StoppingCurves> read_stopping_curves(const config::Table& table, const std::string& key,
                                                           config::Problems& problems);

}  // namespace coupling
