#pragma once

#include <cstddef>
#include <vector>

#include "coupling/assessments/calibrate/model/observations.hpp"
#include "coupling/assessments/calibrate/search/search.hpp"

namespace coupling::calibrate {

/// What a regression did to sets.
struct Adjustment {
    double followed = 0.0;        ///< share of the scatter that the plane takes by chance; 0: nothing moved
    bool is_capped = false;       ///< whether that is more than what sets are widened by at most
    std::vector<Point> before{};  ///< where the sets lay
    /// x'N^-1 x of each set: times its weight, the share of its own place that the plane takes up. 0 where
    /// nothing moved.
    std::vector<double> pulls{};
};

/// Moves the sets of a search to where they would lie if they had shown just what was observed: linear
/// regression of their numbers on their summaries (Beaumont, Zhang & Balding 2002, Genetics 162:2025).
/// Without it the tolerance, which may not be small, makes sets scatter more than the observations do.
/// Weights stay. What scatters about the plane is widened by what the plane followed of chance: E[sum w r^2]
/// is 1 - sum w^2 x'N^-1 x of what it would be.
///
/// `observed`: the summary of what was observed. Nothing moves where there are fewer than five sets for each
/// figure of a summary,
/// nor where some show nothing of a figure.
Adjustment adjust(std::vector<Member>& members, const std::vector<double>& observed);

}  // namespace coupling::calibrate
