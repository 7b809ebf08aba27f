#include "forest/production/unit_production.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/math/elementary.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/production/light_response.hpp"
#include "forest/production/light_use.hpp"
#include "forest/production/nitrogen.hpp"
#include "forest/production/three_pg_modifiers.hpp"

namespace forest {

namespace {

constexpr double slope_saturation = 0.3;
constexpr double g_per_kg = 1000.0;

/// What the trees of one species in one unit have in common.
struct Pool {
    double npp_kg = 0.0;
    double claims = 0.0;  ///< sum of factor * leaf area * weight of light * weight of vigour
};

/// How much a leaf in this response to light [0, 1] weighs when the trees of a pool share its production:
/// trees in the shade make better use of what they get. Fitted to growth under larger trees
/// (forest_demography).
double weight_of_light(double response) {
    constexpr double power = 0.1;
    constexpr double least_response = 0.1;
    return config::pow_of(std::max(response, least_response), power);
}

/// How much a leaf of a tree of this vigour (0, 1] weighs there (share_production). Chosen with the thick
/// stems and the shares of species of old forests (forest_old) in view.
double weight_of_vigour(double vigour) {
    constexpr double power = 0.2;
    return config::pow_of(vigour, power);
}

}  // namespace

YearOfLightUse light_use_of_year(const Species& species, const std::array<MonthConditions, 12>& months,
                                 const Soil& soil) {
    const ThreePg& law = species.three_pg;
    const LightUse light_use;
    const double fertility = soil.fertility * ph_modifier(soil.ph, species.response.min_optimum_ph);
    const double nutrition =
        std::min(1.0, nutrition_modifier(fertility, law.nutrition) *
                          nitrogen_advantage(species.response.nitrogen_class, soil.nitrogen_kg_per_ha_year));
    YearOfLightUse year;
    for (std::size_t m = 0; m < months.size(); ++m) {
        const MonthConditions& month = months[m];
        const int days = days_in_month(static_cast<int>(m) + 1);
        const double physiology =
            physiological_modifier(vpd_modifier(month.vpd_kpa, law.vpd_sensitivity_pmbar),
                                   month.water_modifier, 1.0, Physiology::product);
        const double efficiency = law.quantum_efficiency * nutrition *
                                  temperature_modifier(month.mean_degc, law.temperature) *
                                  std::max(0.0, frost_modifier(month.frost_days, days, law.frost_loss)) *
                                  month.co2_modifier * physiology;
        const double saturation = config::pow_of(month.slope_radiation, -slope_saturation);
        year.physiology[m] = physiology;
        // 1 t/ha is 100 g/m2
        year.npp_gpmj[m] = species.response.npp_multiplier * light_use.npp_share * 100.0 *
                           light_use.gpp_tpha(efficiency, 1.0) * saturation * month.supply;
    }
    return year;
}

std::vector<TreeProduction> share_production(std::span<const Tree> trees, const SpeciesTable& species,
                                             std::span<const AbsorbedByMonth> absorbed,
                                             std::span<const double> vigour, std::span<const double> factors,
                                             std::span<const std::uint32_t> unit,
                                             std::span<const YearOfLightUse> light_use) {
    assert(absorbed.size() == trees.size() && vigour.size() == trees.size() &&
           factors.size() == trees.size() && unit.size() == trees.size());
    std::vector<TreeProduction> production(trees.size());
    std::vector<double> claims(trees.size());
    std::vector<Pool> pools(light_use.size());
    const auto pool_of = [&](std::size_t i) { return unit[i] * species.size() + index_of(trees[i].species); };

    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Tree& tree = trees[i];
        const Species& kind = species[tree.species];
        const YearOfLightUse& use = light_use[pool_of(i)];
        const double prime = vigour[i];
        double npp_g = 0.0;
        double light_mj = 0.0;
        double used_mj = 0.0;
        for (std::size_t m = 0; m < absorbed[i].size(); ++m) {
            npp_g += absorbed[i][m] * use.npp_gpmj[m];
            light_mj += absorbed[i][m];
            used_mj += absorbed[i][m] * use.physiology[m];
        }
        claims[i] = factors[i] * tree.stems * tree.crown.leaf_area_m2 * weight_of_vigour(prime) *
                    weight_of_light(light_response(kind.light.response_class, tree.light_ratio));
        production[i].physiology = light_mj > 0.0 ? prime * used_mj / light_mj : prime;
        Pool& pool = pools[pool_of(i)];
        pool.npp_kg += prime * npp_g / g_per_kg;
        pool.claims += claims[i];
    }
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Pool& pool = pools[pool_of(i)];
        const double share = pool.claims > 0.0 ? claims[i] / pool.claims : 0.0;
        production[i].npp_kg = pool.npp_kg * share / trees[i].stems;
    }
    return production;
}

}  // namespace forest
