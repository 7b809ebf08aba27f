#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/figures/model_verdicts.hpp"
#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// What a figure is about, one of judged_quantities; "" where it is about none of them, such as the effect of
/// a forest.
std::string_view quantity_of(std::string_view figure);

/// The verdicts of a case on one motion model in one quantity.
struct ModelVerdict {
    std::string model;
    QuantityVerdict verdict;
};

/// Which motion model meets which criteria of a case with its default settings, model by model in the order
/// of the list and quantity by quantity; pairs without any criterion are left out.
///
/// A criterion counts for the model that its figure is of. A criterion of the case's own model is held
/// against the other models too where they have the figure ("MODEL.run_out_mean_m") and no criterion of their
/// own. Nothing was fitted with them, so that one marked `fitted` is independent for them.
std::vector<ModelVerdict> model_verdicts(const CaseResult& result);

}  // namespace coupling::validation
