#pragma once

#include <optional>

namespace coupling {

/// What a net or a work costs, in the currency of the risk.
struct BarrierCost {
    std::optional<double> investment;  ///< nothing: its cost is not known
    std::optional<double> life_years;
    double maintenance_percent = 0.0;  ///< of the investment a year
};

/// The cost a year: the annuity of the investment over its life at an interest, and the maintenance.
/// Nothing without investment and life.
std::optional<double> annual_cost(const BarrierCost& cost, double interest_percent);

}  // namespace coupling
