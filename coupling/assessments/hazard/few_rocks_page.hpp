#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::hazard {

/// What a card says where the level of a target rests on few rocks on any slope: how many, of which return
/// period, and that it may be too low or too high. Nothing where enough rocks hit it.
std::optional<report::PageFields> warning_of_few(const HazardResults& results, std::size_t target);

/// What the page begins with: the levels at targets and on the map of each slope, and how much of them so few
/// rocks give that chance may do it.
std::vector<report::PageFields> state_of_slopes(const HazardResults& results);

}  // namespace coupling::hazard
