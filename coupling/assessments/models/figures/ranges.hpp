#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/assessments/models/figures/model_figures.hpp"
#include "coupling/results/figures/model_verdicts.hpp"

namespace coupling::models {

/// Whether models say different things about a figure.
enum class Agreement : std::uint8_t {
    not_known,  ///< a model has no interval
    agree,      ///< the intervals of all models have values in common
    disagree,   ///< the intervals of two models have no value in common
};

/// Which intervals of the models are held against each other.
enum class Intervals : std::uint8_t { none, of_rocks, of_all };

/// A figure over the models that know it.
struct Range {
    std::size_t lowest = 0;   ///< number of the model
    std::size_t highest = 0;  ///< the first of those with the same value
    double low = 0.0;
    double high = 0.0;
    std::optional<double> factor{};  ///< high / low; nothing where low is not above 0
    Agreement agreement = Agreement::not_known;
    Intervals intervals = Intervals::none;
};

/// Nothing where fewer than two models know the figure. Intervals of all that is not known are taken where
/// each of these models has one, else those of the rocks alone where each has one.
std::optional<Range> range_over(const ModelFigure& figure);

/// Whether models give a target different levels.
bool levels_differ(const LevelOfModels& levels);

/// What field cases say of models, as `bannwald models` prints it.
class FieldVerdicts {
public:
    explicit FieldVerdicts(std::span<const std::string> models);

    /// Independent criteria of a model in a quantity of judged_quantities.
    [[nodiscard]] const QuantityVerdict& of(std::size_t model, std::string_view quantity) const;

    /// The models that meet the largest share of their independent criteria, of these those with the most
    /// criteria; none if no model meets half of its criteria or none was judged. The criteria of models may
    /// be those of other cases.
    [[nodiscard]] std::vector<std::size_t> best_on(std::string_view quantity) const;
    /// The models with independent criteria in a quantity.
    [[nodiscard]] std::vector<std::size_t> judged_on(std::string_view quantity) const;

private:
    std::vector<std::vector<QuantityVerdict>> by_model_;
};

}  // namespace coupling::models
