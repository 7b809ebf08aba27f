#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/hazard/risk/risk_sums.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::hazard::risk {

/// A net or a work that stands in this run and not in the one without.
struct NewBarrier {
    std::string name;
    std::string kind;  ///< "net", or of the work
    BarrierCost cost;
    std::optional<double> cost_per_year;  ///< nothing: not known
};

/// What nets and works spare on a slope a year, all exposed targets together.
struct AvoidedOnSlope {
    rockfall::Cover cover = rockfall::Cover::bare;
    Estimate money_without;
    Estimate money_with;
    Estimate deaths_without;
    Estimate deaths_with;
    Estimate money;   ///< spared: of the same rocks without and with them
    Estimate deaths;  ///< the same
};

/// What nets and works spare, and what they cost.
struct AvoidedRisk {
    std::vector<NewBarrier> barriers;
    std::vector<AvoidedOnSlope> slopes;

    /// Of all together; nothing where that of one is not known, or where there is none.
    [[nodiscard]] std::optional<double> cost_per_year() const;
};

/// One figure by another one that is known: of an estimate that may be 0, the upper end is open.
struct Ratio {
    double value = 0.0;  ///< infinite where nothing is spared
    double low = 0.0;
    double high = 0.0;  ///< infinite: open
};

/// Money spared for each unit of cost. Requires a cost above 0.
Ratio benefit_by_cost(const Estimate& money, double cost_per_year);
/// Cost of each unit that is spared, such as a death.
Ratio cost_of_each(const Estimate& spared, double cost_per_year);

/// The nets and works of a site that another run does not name in its tables. `period` is the folder of a
/// return period of that run.
std::vector<NewBarrier> new_barriers(const Site& site, const std::filesystem::path& period,
                                     double interest_percent);

/// Folder of the finished run without nets and works that the risk is compared with; empty: none.
std::filesystem::path run_without(const Scenario& scenario);

/// Refuses a return period of a run without works whose rocks are not the same as those of a scenario and its
/// inputs: InputError naming what differs.
void check_same_rocks(const std::filesystem::path& period, const Scenario& scenario, const Site& site);

}  // namespace coupling::hazard::risk
