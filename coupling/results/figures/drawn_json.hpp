#pragma once

#include <optional>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/results/figures/drawn_figure.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling {

/// A figure with both intervals, and the share of its spread that each parameter brings; null without them.
Json json_drawn(const std::optional<DrawnFigure>& figure, const ParameterDraws& draws, double factor);

/// How many draws there were, and the widths of the parameters.
Json json_draws(const ParameterDraws& draws);

}  // namespace coupling
