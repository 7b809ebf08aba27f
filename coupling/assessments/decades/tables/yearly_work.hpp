#pragma once

#include <cstdint>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"

namespace coupling::decades {

/// Timber and money of a year, per hectare of the whole forest. Stem wood over bark:
/// felled + salvaged = removed + left.
struct YearlyWork {
    double felled_m3pha = 0.0;    ///< of living trees that were cut, whether taken or left
    double salvaged_m3pha = 0.0;  ///< of trees that were dead before, taken or left
    double removed_m3pha = 0.0;   ///< left the forest
    double left_m3pha = 0.0;      ///< of felled and salvaged stems, stayed as logs and stumps
    double revenue_eur_pha = 0.0;
    double harvest_cost_eur_pha = 0.0;    ///< felling and hauling
    double young_cost_eur_pha = 0.0;      ///< planting, tending, fencing
    double fixed_cost_eur_pha = 0.0;      ///< entries, cable lines
    double machine_hours_pha = 0.0;       ///< to bring the removed wood out
    double cable_setups = 0.0;            ///< corridors in the whole forest from which timber was taken
    double standing_value_eur_pha = 0.0;  ///< of the trees that stand at the end of the year
    [[nodiscard]] double margin_eur_pha() const {
        return revenue_eur_pha - harvest_cost_eur_pha - young_cost_eur_pha - fixed_cost_eur_pha;
    }
    YearlyWork& operator+=(const YearlyWork& other);
};

/// Of each year of a member from the start on, also of those without work. Requires area_ha > 0.
std::vector<YearlyWork> work_by_year(const Names& names, const MemberYears& member, double area_ha);

/// A figure of the work of a year as tables name it.
struct WorkFigure {
    const char* quantity;
    double (*of)(const YearlyWork&);
};
/// felled_m3pha, salvaged_m3pha, removed_m3pha, left_m3pha and contribution_margin_eur_pha,
/// machine_hours_pha, cable_setups, standing_value_eur_pha.
const std::vector<WorkFigure>& work_figures();

}  // namespace coupling::decades
