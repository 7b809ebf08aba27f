#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "coupling/assessments/decades/tables/band.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/inputs/scenario/decision_settings.hpp"

namespace coupling::decades {

/// What a course brings and costs, per hectare.
///
/// The present value counts what stands: a regime that fells its stock gains what the stock loses. So it is
/// the discounted margins of the work, and the discounted value of the trees that stand at the end less that
/// of those at the start.
struct CourseMoney {
    std::size_t course = 0;
    std::vector<double> present_values_eur_pha{};  ///< [replicate], of work and stock
    Band removed_m3pha_a_year{};
    Band net_eur_pha_a_year{};
    Band present_value_eur_pha{};
    Band work_value_eur_pha{};   ///< of it, margins of the work
    Band stock_value_eur_pha{};  ///< of it, trees that stand at the end less those of the start
};

CourseMoney money_of(std::span<const Series> series, std::size_t course, const DecisionSettings& settings);

/// Pairs of replicates: a minus b.
std::optional<PairedDifference> difference_in_value(const CourseMoney& a, const CourseMoney& b);

}  // namespace coupling::decades
