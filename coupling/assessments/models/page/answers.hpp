#pragma once

#include <string>
#include <vector>

#include "coupling/assessments/models/figures/comparison.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::models {

/// A figure as pages show it: three significant digits, classes as whole numbers; an en dash where it is not
/// known.
std::string shown_value(const FigureKey& key, double value);

/// "one 1 of 1, other 0 of 2" with the names of models: independent criteria that these models meet in a
/// quantity.
std::string verdicts_of_models(const Comparison& comparison, const std::vector<std::size_t>& models,
                               const std::string& quantity);

/// The first screen: for the targets that most rocks reach, for the slope and for the levels of a hazard map
/// the range of the main figures over the models, whether these disagree, and which is judged best. Rows of
/// models_page.html.
std::vector<report::PageFields> answers(const Comparison& comparison);

/// Ids of the targets, those that most rocks reach on the bare slope under any model first.
std::vector<std::string> targets_by_reach(const std::vector<ModelFigure>& figures);

}  // namespace coupling::models
