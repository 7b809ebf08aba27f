#pragma once

#include <span>
#include <vector>

namespace coupling {

/// The mean over replicates of a figure that is a ratio, such as rocks stopped of rocks that would arrive: of
/// all that its replicates are ratios to, so that a replicate in which two rocks arrive does not count as
/// much as one with fifty. What each replicate brings to it: their mean is that ratio, and their scatter that
/// of the ratio (linearised; Cochran 1977, Sampling Techniques, 6.4). Requires as many weights as values,
/// none below 0, one above.
std::vector<double> parts_of_ratio(std::span<const double> values, std::span<const double> weights);

}  // namespace coupling
