#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::hazard {

/// "with forest", "bare slope" in the language in use.
const std::string& slope_words(Cover cover);
/// "95th percentile of the energies".
std::string energy_in_words(HazardEnergy energy);
/// The same, or "largest energy of only 7 rocks" where these are too few.
std::string energy_in_words(const EnergyOfRocks& energy, HazardEnergy settings);
/// How many rocks a level needs that chance alone would not give.
std::string least_of_level();
/// "high hazard (red)".
std::string level_in_words(Level level);

/// Rows of the tables of a page, and names on its maps: the rest stands in tables/hazard_targets.csv.
inline constexpr std::size_t most_rows = 10;
/// With roads, and with targets whose level the forest changes.
inline constexpr std::size_t most_rows_of_all = 15;

/// What the card of a target says of few rocks (few_rocks_page.hpp); nothing where there are enough.
using FewRocksAt = std::function<std::optional<report::PageFields>(std::size_t target)>;

/// Fields of the first screen: how many targets are hit, which levels, what the
/// forest lowers and raises, cards of the worst ones and their table; and of the tables of arrivals and
/// energies further down.
report::PageFields answer_fields(const HazardResults& results, const FewRocksAt& few_rocks);

}  // namespace coupling::hazard
