#pragma once

#include <string>
#include <vector>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::hazard {

/// "with forest", "bare slope" in the language in use.
const std::string& slope_words(Cover cover);
/// "100 years".
std::string years_in_words(double years);
/// "95th percentile of the energies".
std::string energy_in_words(HazardEnergy energy);
/// The same, or "largest energy of only 7 rocks" where these are too few.
std::string energy_in_words(const EnergyOfRocks& energy, HazardEnergy settings);
/// "high hazard (red)".
std::string level_in_words(Level level);

/// Rows of the tables of a page, and names on its maps: the rest stands in tables/hazard_targets.csv.
inline constexpr std::size_t most_rows = 10;

/// Targets that stand on the page: those that rocks hit in the order of `ranked_targets`, then the others.
std::vector<std::size_t> shown_targets(const HazardResults& results, std::size_t most);

/// Where the forest makes a level higher than it is on the bare slope.
struct RaisedByForest {
    std::size_t targets = 0;
    double area_ha = 0.0;  ///< of the map
};
RaisedByForest raised_by_forest(const HazardResults& results);

/// Fields of the first screen: how many targets are hit, cards of the worst ones and their table, what the
/// forest makes worse; and of the tables of arrivals and energies further down.
report::PageFields answer_fields(const HazardResults& results);

}  // namespace coupling::hazard
