#pragma once

#include <optional>
#include <string>
#include <vector>

#include "forest/parameters.hpp"
#include "forest/year.hpp"
#include "validation/engine/forest_cases/remeasured/stand.hpp"

namespace coupling::validation::forest_cases::remeasured {

/// What a simulation made of a plot.
struct Regrown {
    std::vector<std::optional<double>> end_dbh_cm;  ///< by tree of the first measurement; nothing: it died
    std::vector<IngrownTree> ingrown;               ///< from the least diameter on
};

/// Grows a plot from its first to its second measurement by forest::grow_year under the weather of these
/// years.
///
/// The plot borders on itself: beyond its edge the same forest goes on. Missing heights and ages are filled
/// in as a run does it. Trees that were felled are felled in their years, after the year's growth (in the
/// first year before all growth). Nothing is known of dead wood at the start. The same key gives the same
/// bytes.
Regrown regrow(const MeasuredStand& stand, const forest::SpeciesTable& species,
               const forest::Parameters& parameters, const forest::YearKey& key);

/// What is filled in or left out of the trees that a plot starts with, such as missing heights.
std::vector<std::string> notes_on_start(const MeasuredStand& stand, const forest::SpeciesTable& species);

}  // namespace coupling::validation::forest_cases::remeasured
