#pragma once

#include <string>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/report/map/map_sheet.hpp"
#include "coupling/results/report/map/scale.hpp"

namespace coupling::hazard {

// What the page says of the return period of the arrival, beside that of the release.

/// A slope and a number of years in words.
const std::string& words_of(Cover cover);
std::string years_text(double years);

/// Mean time between two arrivals in words; a dash where it is not known.
std::string arrival_period(double release_years, double arrive_percent);

/// The maps of levels by the return period of the arrival, with what that is.
std::string levels_by_arrival(const HazardResults& results, const report::MapSheet& sheet,
                              const report::ColourScale& by_level);

/// Shares of the rocks of each return period that arrive at the targets; nothing without targets.
std::string arrivals_table(const HazardResults& results);

}  // namespace coupling::hazard
