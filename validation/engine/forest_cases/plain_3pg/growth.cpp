#include "validation/engine/forest_cases/plain_3pg/growth.hpp"

#include <algorithm>
#include <utility>

#include "forest/climate/calendar.hpp"
#include "forest/production/power.hpp"
#include "validation/engine/forest_cases/plain_3pg/sizes.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

double by_age(double years, const ByAge& property, double power_of_age) {
    return forest::by_age(years, property.young, property.mature, property.half_years, power_of_age);
}

/// Litterfall by age; from nothing at planting it is the limit of the law for ever smaller first rates, a
/// step at the median age (r3PG divides by the first rate).
double litterfall_of_age(double age_years, const forest::Litterfall& litterfall) {
    if (litterfall.initial_pmonth > 0.0 || litterfall.median_months * litterfall.mature_pmonth == 0.0) {
        return forest::litterfall_pmonth(age_years, litterfall);
    }
    constexpr double months_per_year = 12.0;
    const double months = months_per_year * age_years;
    return months < litterfall.median_months   ? 0.0
           : months > litterfall.median_months ? litterfall.mature_pmonth
                                               : 0.5 * litterfall.mature_pmonth;
}

/// Conductance by CO2. Where it halves from 350 to 700 ppm the law's parameter is infinite and it is 350 /
/// CO2.
double co2_conductance(double co2_ppm, double at_700) {
    constexpr double reference_ppm = 350.0;
    return at_700 == 0.5 ? reference_ppm / co2_ppm : forest::co2_conductance_modifier(co2_ppm, at_700);
}

int months_since_planting(const StartingSpecies& species, YearMonth when) {
    return when.count() - species.planted.count();
}

/// The month before; r3PG lets the month before January be 0.
bool dormant_before(const Parameters& parameters, int month) {
    return dormant(parameters, month - 1);
}

/// Production first grows the leaves of last year again.
double after_repaying_debt(Stocks& stocks, double npp_tpha) {
    if (stocks.foliage == 0.0) {
        stocks.foliage = stocks.foliage_debt;
    }
    const double repaid = std::min(npp_tpha, stocks.foliage_debt);
    stocks.foliage_debt -= repaid;
    return npp_tpha - repaid;
}

}  // namespace

void grow_older(Stand& stand, const Inputs& inputs, YearMonth when) {
    constexpr double months_per_year = 12.0;
    const bool first = when.count() == inputs.site.from.count();
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const Parameters& parameters = inputs.parameters[i];
        AgeState& age = stand.species[i].age;
        const int months = months_since_planting(inputs.species[i], when);
        age.years = months / months_per_year;
        age.previous_years = first ? age.years : (months - 1) / months_per_year;
        age.sla_m2pkg = by_age(age.previous_years, parameters.sla_m2pkg, 2.0);
        age.branch_share = by_age(age.previous_years, parameters.branch_share, 1.0);
        age.wood_density_tpm3 = by_age(age.previous_years, parameters.wood_density_tpm3, 1.0);
        const RandomMortality& random = parameters.random_mortality;
        age.random_mortality =
            by_age(age.years, {random.initial, random.mature, random.median_years}, random.shape);
        age.litterfall_pmonth = litterfall_of_age(age.previous_years, parameters.litterfall);
    }
}

bool plant(Stand& stand, const Inputs& inputs, YearMonth when) {
    const bool first = when.count() == inputs.site.from.count();
    bool any = false;
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const StartingSpecies& start = inputs.species[i];
        const int months = months_since_planting(start, when);
        if (first ? months < 0 : months != 0) {
            continue;
        }
        Stocks& stocks = stand.species[i].stocks;
        stocks = {start.stems_pha, start.stem_tpha, start.root_tpha, start.foliage_tpha, 0.0};
        if (first && dormant(inputs.parameters[i], when.month)) {
            std::swap(stocks.foliage, stocks.foliage_debt);
        }
        any = true;
    }
    return any;
}

bool turn_leaves(Stand& stand, const Inputs& inputs, int month) {
    bool any = false;
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        SpeciesMonth& species = stand.species[i];
        const bool off = dormant(inputs.parameters[i], month);
        if (off == dormant_before(inputs.parameters[i], month)) {
            continue;
        }
        if (off) {
            species.stocks.foliage_debt = species.stocks.foliage;
            species.stocks.foliage = 0.0;
            species.canopy.lai = 0.0;
        } else {
            constexpr double m2pm2_per_m2pkg_tpha = 0.1;
            species.canopy.lai = species.stocks.foliage_debt * species.age.sla_m2pkg * m2pm2_per_m2pkg_tpha;
        }
        any = true;
    }
    return any;
}

void climate_modifiers(Stand& stand, const Inputs& inputs, const ClimateMonth& month) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const Parameters& parameters = inputs.parameters[i];
        Modifiers& f = stand.species[i].modifiers;
        f.temperature = forest::temperature_modifier(month.tave_degc, parameters.temperature);
        f.temperature_of_conductance = forest::conductance_temperature_modifier(
            month.tave_degc, month.tmax_degc, parameters.temperature);
        f.frost = forest::frost_modifier(month.frost_days, forest::days_in_month(month.when.month),
                                         parameters.frost_loss);
        f.co2_assimilation = forest::co2_assimilation_modifier(month.co2_ppm, parameters.assimilation_at_700);
        f.co2_conductance = co2_conductance(month.co2_ppm, parameters.conductance_at_700);
        f.age = forest::age_modifier(stand.species[i].age.previous_years, parameters.age);
    }
}

void limit_production(Stand& stand, const Inputs& inputs, const ClimateMonth& month,
                      const Settings& settings) {
    const Site& site = inputs.site;
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const Parameters& parameters = inputs.parameters[i];
        SpeciesMonth& species = stand.species[i];
        Modifiers& f = species.modifiers;
        species.water.vpd_kpa =
            settings.light == LightModel::layers
                ? month.vpd_kpa * config::exp2_of(-species.canopy.lai_above / parameters.vpd_halving_lai)
                : month.vpd_kpa;
        f.vpd = forest::vpd_modifier(species.water.vpd_kpa, parameters.vpd_sensitivity_pmbar);
        const forest::SoilWaterCurve curve =
            site.soil_class > 0 ? forest::soil_water_curve(site.soil_class) : parameters.soil_water;
        f.soil_water = site.soil_class == 0
                           ? 1.0
                           : forest::soil_water_modifier(stand.water.soil_mm / site.max_water_mm, curve);
        const forest::NutritionCurve& nutrition = parameters.nutrition;
        f.nutrition =
            nutrition.power == 0.0 ? 1.0 : forest::nutrition_modifier(inputs.species[i].fertility, nutrition);
        f.physiology = forest::physiological_modifier(f.vpd, f.soil_water, f.age, settings.physiology);
        if (settings.physiology == forest::Physiology::scarcer) {
            f.temperature_of_conductance = 1.0;
        }
    }
}

void produce(Stand& stand, const Inputs& inputs) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const Parameters& parameters = inputs.parameters[i];
        SpeciesMonth& species = stand.species[i];
        const Modifiers& f = species.modifiers;
        Production& production = species.production;
        production.quantum_efficiency = species.canopy.lai == 0.0
                                            ? 0.0
                                            : parameters.quantum_efficiency * f.nutrition * f.temperature *
                                                  f.frost * f.co2_assimilation * f.physiology;
        production.gpp =
            parameters.light_use.gpp_tpha(production.quantum_efficiency, species.canopy.absorbed_mjpm2);
        production.npp = production.gpp * parameters.light_use.npp_share;
    }
}

void allocate(Stand& stand, const Inputs& inputs, int month) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const Parameters& parameters = inputs.parameters[i];
        SpeciesMonth& species = stand.species[i];
        Stocks& stocks = species.stocks;
        Production& p = species.production;
        const double m0 = parameters.root_response_at_zero;
        p.root_share = forest::root_share(parameters.root_share, species.modifiers.physiology,
                                          m0 + (1.0 - m0) * inputs.species[i].fertility);
        p.stem_share = (1.0 - p.root_share) / (1.0 + species.sizes.foliage_to_stem);
        p.foliage_share = 1.0 - p.root_share - p.stem_share;

        if (dormant(parameters, month)) {
            p.foliage_loss = dormant_before(parameters, month) ? 0.0 : stocks.foliage_debt;
            p.root_loss = p.root_growth = p.stem_growth = p.foliage_growth = 0.0;
            continue;
        }
        const double npp_tpha = after_repaying_debt(stocks, p.npp);
        p.foliage_loss = species.age.litterfall_pmonth * stocks.foliage;
        p.root_loss = parameters.root_turnover_pmonth * stocks.root;
        p.foliage_growth = npp_tpha * p.foliage_share;
        p.root_growth = npp_tpha * p.root_share;
        p.stem_growth = npp_tpha * p.stem_share;
        stocks.foliage += p.foliage_growth - p.foliage_loss;
        stocks.root += p.root_growth - p.root_loss;
        stocks.stem += p.stem_growth;
    }
}

void measure_growth(Stand& stand, const Inputs& inputs) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        Sizes& sizes = stand.species[i].sizes;
        const double before_m3pha = sizes.volume_m3pha;
        sizes.volume_m3pha = volume_m3pha(stand.species[i], inputs.parameters[i]);
        const double change = sizes.volume_m3pha - before_m3pha;
        sizes.volume_change_m3pha = stand.species[i].canopy.lai == 0.0 || change <= 0.0 ? 0.0 : change;
        sizes.volume_total_m3pha += sizes.volume_change_m3pha;
    }
}

}  // namespace coupling::validation::forest_cases::plain_3pg
