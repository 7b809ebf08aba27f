#pragma once

#include <string>
#include <vector>

#include "coupling/exchange/regimes/planned_years.hpp"

namespace coupling::decades {

// When a regime acts, in the words of the page, as text. `start_calendar_year` is that of year 0 of the run.

/// "in 2026 and 2046", "each year from 2026 to 2055", "every 5 years from 2026 to 2051", with the condition
/// that must hold; "1 year after salvage" where that decides.
std::string when_in_words(const PlannedYears& planned, const Regime& regime, std::size_t row,
                          int start_calendar_year);

/// Years for a small label on a map: "2026, 2046", "2026 ...", empty without years of the calendar alone.
std::string years_on_map(const PlannedYears& planned, int start_calendar_year);

}  // namespace coupling::decades
