#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/results/figures/drawn_figure.hpp"

namespace coupling {

/// What is drawn, in the language of the page: "losses at all grounds", "losses on pasture".
std::string name_of(const ParameterDraws::Component& component);

/// A component of the draws and the share of a figure's spread that it brings [0, 1].
struct NamedShare {
    std::string name;
    double share = 0.0;
};

/// The components that bring at least a twentieth of the spread, largest first, at most four.
std::vector<NamedShare> main_causes(const DrawnFigure& figure, const ParameterDraws& draws);

/// The same in words: "losses at all grounds 41 %, friction 12 %"; "" where none stands out.
std::string main_causes_in_words(const DrawnFigure& figure, const ParameterDraws& draws);

/// What is to be known of the second interval: that it holds a spread that chance could hide, as draws show
/// none, or that its lower end is not known; "" of others.
std::string spread_in_words(const DrawnFigure& figure);

}  // namespace coupling
