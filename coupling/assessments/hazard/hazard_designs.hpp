#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/nets/figures/barrier_design.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::hazard {

struct FinishedPeriod;
struct HazardResults;

/// The barrier that the rocks of a return period ask for at a target, as the run of that return period has
/// it.
struct PeriodDesign {
    std::size_t target = 0;  ///< as in the site
    double return_period_years = 0.0;
    rockfall::Cover cover = rockfall::Cover::bare;
    std::uint64_t reached = 0;
    std::optional<BarrierDesign> design;  ///< nothing: too few rocks; what it would hold stays empty
};

/// From target_design.csv of each return period; none where design.rule asks for none. Throws
/// config::InputError (file, data) for tables that the run did not write.
std::vector<PeriodDesign> designs_of(std::span<const FinishedPeriod> periods, const Site& site,
                                     const DesignSettings& settings);

/// What a net or a work did with the rocks of a return period, as the run of that return period has it.
struct PeriodBarrier {
    bool is_net = true;
    std::size_t number = 0;  ///< of the nets or of the works of the site
    double return_period_years = 0.0;
    rockfall::Cover cover = rockfall::Cover::bare;
    std::uint64_t rocks = 0;    ///< that fell
    std::uint64_t reached = 0;  ///< came to it
    /// Of these, by the column of nets.csv or works.csv: "held", "over" ...
    std::map<std::string, std::uint64_t> outcomes;
};

/// From nets.csv and works.csv of each return period. Throws config::InputError (file, data) for tables that
/// the run did not write.
std::vector<PeriodBarrier> barriers_of(std::span<const FinishedPeriod> periods, const Site& site);

/// The section of the page: nets and works by return period, in rocks; nothing without any.
std::optional<report::PageFields> barrier_fields(const HazardResults& results);

/// Nets that more than 5 % of the rocks that reach them in a return period break, each with the slope and the
/// return period where most do, and the pages of these return periods; nothing without any.
std::optional<report::PageFields> weak_barrier_fields(const HazardResults& results);

/// Names of nets and works that no rock reaches on any slope, whatever they cost; "" without any.
std::string unreached_barriers(const HazardResults& results);

/// The section of the page: targets by return period; nothing without designs.
std::optional<report::PageFields> design_fields(const HazardResults& results,
                                                std::span<const std::size_t> targets);

}  // namespace coupling::hazard
