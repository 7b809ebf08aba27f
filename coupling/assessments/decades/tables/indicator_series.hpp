#pragma once

#include <span>
#include <vector>

#include "coupling/assessments/decades/tables/comparison.hpp"

namespace coupling::decades {

/// Protection by the living trees alone at each target (protection_living_percent), of the years in which
/// enough rocks arrive over the bare slope; nothing where it was not simulated.
void add_living(std::vector<Series>& all_series, const Names& names, const Site& site,
                std::span<const MemberYears> members);

/// Stems with h/d above 90, crown cover, regeneration, wood lost in five years, carbon in stand, dead wood
/// and products.
void add_indicators(std::vector<Series>& all_series, const Names& names,
                    std::span<const MemberYears> members);

/// Trees that left the forest in the five years up to each year for another reason than felling [m3/ha];
/// from year 5 on.
std::vector<double> lost_in_five_years_m3pha(const MemberYears& member);

/// Carbon per hectare at the end of a year [t/ha].
struct CarbonYear {
    double stand_tpha = 0.0;      ///< above ground
    double dead_wood_tpha = 0.0;  ///< stems of standing and lying dead wood
    double products_tpha = 0.0;   ///< in sawn wood of what was removed since the start
};

/// Half of dry mass is carbon (IPCC 2006 [lit*]: 0.48 broadleaves, 0.51 conifers). Half of the removed stem
/// wood becomes sawn wood [choice], which leaves use with a half-life of 35 years (IPCC 2014, KP Supplement,
/// Table 2.8.2); the rest counts as gone in its year. Products of before the start are not known: 0.
std::vector<CarbonYear> carbon_by_year(const MemberYears& member);

}  // namespace coupling::decades
