#include "coupling/inputs/nets/barrier_cost.hpp"

#include <cmath>

#include "config/units/constants.hpp"

namespace coupling {

std::optional<double> annual_cost(const BarrierCost& cost, double interest_percent) {
    if (!cost.investment || !cost.life_years) {
        return std::nullopt;
    }
    const double interest = interest_percent / config::percent;
    // i / (1 - (1 + i)^-n), whose limit without interest is 1 / n.
    const double annuity = interest > 0.0 ? interest / -std::expm1(-*cost.life_years * std::log1p(interest))
                                          : 1.0 / *cost.life_years;
    return *cost.investment * (annuity + cost.maintenance_percent / config::percent);
}

}  // namespace coupling
