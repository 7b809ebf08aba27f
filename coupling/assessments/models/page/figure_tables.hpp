#pragma once

#include <string>
#include <vector>

#include "coupling/assessments/models/figures/comparison.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::models {

/// Targets beyond these are in models.csv alone.
inline constexpr std::size_t most_shown_targets = 10;

/// All figures of a return period (0: of a run without) as tables, one a place, a column a model: the slope,
/// the targets that most rocks reach, the nets. A group of figures begins with what field cases say of each
/// model in its quantity.
std::vector<report::PageFields> figure_tables(const Comparison& comparison, double return_period_years);

}  // namespace coupling::models
