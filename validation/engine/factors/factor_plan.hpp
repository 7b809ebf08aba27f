#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "validation/engine/case/case_files.hpp"
#include "validation/engine/slope/recipe.hpp"

namespace coupling::validation {

/// Basal area of the stand: a setting that follows from others.
inline constexpr const char* basal_area = "stand.basal_area_m2pha";

/// A setting and the values it takes.
struct Factor {
    std::string setting;         ///< such as "stand.stems_per_ha"
    std::vector<double> values;  ///< rising, at least two
    bool crossed = true;         ///< with all others that are crossed; else moved alone from the recipe
};

/// What the literature agrees on: a figure rises or falls as a setting grows.
struct Direction {
    std::string figure;
    std::string setting;  ///< of a factor, or basal_area
    bool rises = true;
    std::string source;
};

/// Values of all factors, in their order.
using Combination = std::vector<double>;

/// What a case of factors lets vary and expects.
struct FactorPlan {
    std::vector<Factor> factors;
    std::vector<Direction> directions;
    Combination base;  ///< the recipe's own values

    /// All combinations of the crossed factors, the others at their base; then those moved alone.
    [[nodiscard]] std::vector<Combination> combinations() const;
    /// The setting that moves alone in a combination, by its place in combinations(); empty where all move.
    [[nodiscard]] std::string alone_at(std::size_t place) const;
    /// Whether all factors that are moved alone stand at their base.
    [[nodiscard]] bool is_crossed(const Combination& combination) const;
    /// Place of a setting among the factors; their number for any other.
    [[nodiscard]] std::size_t place_of(const std::string& setting) const;
    /// Overrides of the recipe. The standard deviation of DBH keeps its ratio to the mean.
    [[nodiscard]] std::vector<std::string> overrides(const Combination& combination,
                                                     const Recipe& recipe) const;
};

/// Names of the figures that directions may be about.
const std::vector<std::string>& factor_figures();

/// Reads factors.csv (`setting,values,how`; how is crossed or alone) and directions.csv
/// (`figure,setting,expected,source`; expected is rises or falls). Throws InputError with every problem.
FactorPlan read_factor_plan(const CaseFiles& files, const Recipe& recipe);

/// m2/ha of stems whose DBHs have this mean and deviation.
double basal_area_m2pha(double stems_per_ha, double dbh_mean_cm, double dbh_deviation_cm);

}  // namespace coupling::validation
