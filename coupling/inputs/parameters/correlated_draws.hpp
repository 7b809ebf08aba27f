#pragma once

#include <span>
#include <vector>

#include "coupling/inputs/parameters/parameter_draws.hpp"

namespace coupling {

/// Of standard numbers of draws: those of all factors lie within.
inline constexpr double most_deviations = 3.0;

/// The independent numbers from which `correlated` makes these, but for its cut-off. What a component shares
/// with another one counts for that one.
std::vector<double> independent_of(std::span<const ParameterDraws::Component> components,
                                   const std::vector<double>& numbers);

}  // namespace coupling
