#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/tree.hpp"

namespace forest {

/// Conditions for photosynthesis in a month, in a production unit.
struct MonthConditions {
    double mean_degc = 0.0;
    double frost_days = 0.0;
    double vpd_kpa = 0.0;          ///< mean of daytime
    double water_modifier = 1.0;   ///< [0, 1], soil water
    double co2_modifier = 1.0;     ///< > 0, of quantum efficiency, 1 = at 350 ppm
    double supply = 1.0;           ///< [0, 1], actual / potential evapotranspiration
    double slope_radiation = 1.0;  ///< > 0, radiation on the slope / on the flat
};

/// Net production of a species per absorbed light in a production unit, month by month, without the effect of
/// age.
struct YearOfLightUse {
    std::array<double, 12> npp_gpmj{};    ///< net primary production, dry matter per absorbed solar radiation
    std::array<double, 12> physiology{};  ///< [0, 1], limits of air and soil water
};

/// Radiation-use efficiency of 3-PG (Landsberg & Waring 1997; physiology as a product, Forrester & Tang 2016)
/// times the species' calibrated multiplier. Light is used less well where there is much of it: times
/// (radiation on the slope / on the flat)^-0.3 [choice], so that a steep shady slope loses less production
/// than light. The soil's fertility is lowered where its top is more acid than the species likes; what it
/// leaves is multiplied by the species' nitrogen_advantage(), up to 1.
YearOfLightUse light_use_of_year(const Species& species, const std::array<MonthConditions, 12>& months,
                                 const Soil& soil);

/// Radiation that a tree record absorbed, all its stems together, by month [MJ].
using AbsorbedByMonth = std::array<double, 12>;

/// A tree's share of the production of its unit, per stem.
struct TreeProduction {
    double npp_kg = 0.0;
    double physiology = 1.0;  ///< [0, 1], of the year, weighted by absorbed light, its vigour included
};

/// Shares the production of each unit and species among its trees.
///
/// A species makes in a unit what its trees absorb times its efficiency, each tree's light discounted by its
/// vigour; a tree's part of it is in proportion to leaf area * the light response to the power 0.1 * vigour
/// to the power 0.2 * its own factor [choice in the spirit of PICUS v1.4; the first power after the growth of
/// suppressed trees in inventories, the second after old forests]. So what a tree has beside its like it
/// takes from them, and a unit makes no more for it. Lost vigour is mostly a loss of the unit: with its
/// full weight in the parts, young trees in the shade got what old ones above them lost, and trees of 10 and
/// of 60 cm grew alike in old forests.
///
/// `absorbed`, `vigour` (forest/deaths/vigour.hpp), `factors` (growth_factors()) and `unit` have one entry a
/// tree, `light_use` one a unit and species (unit by unit).
std::vector<TreeProduction> share_production(std::span<const Tree> trees, const SpeciesTable& species,
                                             std::span<const AbsorbedByMonth> absorbed,
                                             std::span<const double> vigour, std::span<const double> factors,
                                             std::span<const std::uint32_t> unit,
                                             std::span<const YearOfLightUse> light_use);

}  // namespace forest
