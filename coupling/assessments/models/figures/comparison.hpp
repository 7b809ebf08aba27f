#pragma once

#include <string>
#include <vector>

#include "coupling/assessments/models/figures/model_figures.hpp"
#include "coupling/assessments/models/figures/ranges.hpp"

namespace coupling::models {

/// What a comparison of motion models shows.
struct Comparison {
    std::vector<std::string> models;  ///< names, in the order of the call
    std::vector<ModelFigure> figures;
    std::vector<LevelOfModels> levels;  ///< of a hazard map
    FieldVerdicts verdicts;
};

}  // namespace coupling::models
