#pragma once

#include <ostream>
#include <vector>

#include "coupling/assessments/models/figures/comparison.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::models {

/// The layouts of the tables that are written here; that of levels is for hazard maps.
const std::vector<TableLayout>& models_layouts();

/// One row a figure under a model.
void write_models(std::ostream& out, const Comparison& comparison);
/// One row a figure that two models or more know: its range over the models.
void write_ranges(std::ostream& out, const Comparison& comparison);
/// One row a target, slope and model of a hazard map.
void write_levels(std::ostream& out, const Comparison& comparison);

}  // namespace coupling::models
