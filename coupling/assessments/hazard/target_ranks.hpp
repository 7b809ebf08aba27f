#pragma once

#include <cstddef>
#include <vector>

#include "coupling/assessments/hazard/hazard_results.hpp"

namespace coupling::hazard {

/// Targets that rocks hit, on any slope, the highest level first; of equal ones roads and what has persons or
/// traffic before the others, then what is hit most often.
std::vector<std::size_t> ranked_targets(const HazardResults& results);
/// The first of them, then others until there are `most`.
std::vector<std::size_t> first_targets(const HazardResults& results, std::size_t most);
/// The first of them, then others until there are `most`, and of the rest all roads and other lines, and
/// those whose level the forest changes until there are `most_of_all`.
std::vector<std::size_t> listed_targets(const HazardResults& results, std::size_t most,
                                        std::size_t most_of_all);

}  // namespace coupling::hazard
