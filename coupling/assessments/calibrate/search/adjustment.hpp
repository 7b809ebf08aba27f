#pragma once

#include <cstddef>
#include <vector>

#include "coupling/assessments/calibrate/model/observations.hpp"
#include "coupling/assessments/calibrate/search/search.hpp"

namespace coupling::calibrate {

/// Moves the sets of a search to where they would lie if they had shown just what was observed: linear
/// regression of their numbers on their summaries (Beaumont, Zhang & Balding 2002, Genetics 162:2025).
/// Without it the tolerance, which may not be small, makes sets scatter more than the observations do.
/// Weights stay.
///
/// `observed`: the summary of what was observed. Nothing moves where there are fewer than five sets for each
/// figure of a summary.
void adjust(std::vector<Member>& members, const std::vector<double>& observed);

}  // namespace coupling::calibrate
