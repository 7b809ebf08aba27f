#pragma once

#include <limits>
#include <span>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/exchange/regimes/intervention.hpp"

namespace coupling {

/// Years from here on are calendar years, as in [run] first_year; lower ones count from the start of the run.
inline constexpr int least_calendar_year = 1500;

/// The years that a regime is for: 0 (the start) to `last`.
struct RunYears {
    int start_calendar_year = 0;  ///< of year 0; 0: not known, calendar years are refused
    int last = std::numeric_limits<int>::max();
};

/// Turns calendar years in first_year and last_year into years of the run. Adds a problem (data) for each row
/// that mixes them with years of the run in another row, that names a calendar year outside the run, or whose
/// first_year comes after the last year: it could never act.
void use_run_years(std::vector<Intervention>& rows, const RunYears& run, config::Problems& problems);

}  // namespace coupling
