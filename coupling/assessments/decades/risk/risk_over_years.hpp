#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/consequences/consequence.hpp"
#include "coupling/assessments/consequences/risk_plan.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/band.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::decades {

/// Figures a year of a place on a slope in a member, by year with rocks.
using RiskByYear = std::map<std::int32_t, consequences::Quantities>;

/// Risk at a place in all members.
struct RiskAtPlace {
    std::string id;  ///< of the target, or "all"
    /// [cover][course][replicate]. Individual risk of all targets together is NaN: one person is not in all
    /// of them.
    std::array<std::vector<std::vector<RiskByYear>>, rockfall::covers> values;

    [[nodiscard]] const std::vector<RiskByYear>& at(Cover cover, std::size_t course) const {
        return values[static_cast<std::size_t>(cover)][course];
    }
};

/// What rocks cost at the exposed targets, by regime, climate, replicate and year.
///
/// In truth `rocks_per_year` rocks start on the whole slope, as often as the simulated ones start at each
/// place: a simulated rock stands for rocks_per_year / (rocks that started in the year). What it does where
/// it hits is that of `consequences::consequence`.
struct RiskOverYears {
    consequences::RiskPlan plan;
    double rocks_per_year = 0.0;
    std::vector<RiskAtPlace> targets;  ///< as in the plan
    RiskAtPlace all;                   ///< sum over them
};

/// Id of all exposed targets together.
inline constexpr const char* all_targets = "all";

/// Requires members of these names, and the targets of their site. A year in which no rock started has no
/// figures.
RiskOverYears risk_over_years(const Names& names, std::span<const rockfall::Target> targets,
                              std::span<const MemberYears> members, const consequences::RiskPlan& plan,
                              double rocks_per_year);

/// Mean of the years after the start; each year with rocks stands for those since the one before. Nothing
/// without such a year.
std::optional<consequences::Quantities> mean_after_start(const RiskByYear& years);

/// Money of the years after the start, discounted to it; each year with rocks stands for those since the one
/// before.
double present_value_of_risk(const RiskByYear& years, double discount_percent);

/// Figures over replicates.
struct RiskBands {
    std::size_t replicates = 0;
    std::array<Band, consequences::quantities> of{};
    [[nodiscard]] const Band& at(consequences::Quantity quantity) const {
        return of[consequences::index_of(quantity)];
    }
};
/// Nothing where no replicate knows the year.
std::optional<RiskBands> risk_in_year(const RiskAtPlace& place, Cover cover, std::size_t course,
                                      std::int32_t year);
/// Of the means after the start.
std::optional<RiskBands> mean_risk(const RiskAtPlace& place, Cover cover, std::size_t course);

/// Years with figures, rising.
std::vector<std::int32_t> years_of(const RiskAtPlace& place);

}  // namespace coupling::decades
