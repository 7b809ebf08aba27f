#include "validation/engine/forest_cases/plain_3pg/water.hpp"

#include <algorithm>

#include "forest/climate/calendar.hpp"
#include "forest/production/power.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

constexpr double wet_soil_conductance_mps = 0.0025;  // Forrester & Tang 2016
constexpr double air_resistance_per_lai_spm = 5.0;   // the same
constexpr double soil_vpd_halving_lai = 5.0;         // the same

double total_lai(const Stand& stand) {
    double sum = 0.0;
    for (const SpeciesMonth& species : stand.species) {
        sum += species.canopy.lai;
    }
    return sum;
}

/// Conductances of crowns, and the resistance of the air between them and the air above the stand.
void set_conductances(Stand& stand, const Inputs& inputs) {
    const double lai = total_lai(stand);
    double tallest_m = 0.0;
    for (const SpeciesMonth& species : stand.species) {
        if (species.canopy.lai > 0.0) {
            tallest_m = std::max(tallest_m, species.sizes.height_m);
        }
    }
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const Parameters& parameters = inputs.parameters[i];
        SpeciesMonth& species = stand.species[i];
        const Modifiers& f = species.modifiers;
        if (species.canopy.lai == 0.0) {
            species.water.conductance_mps = 0.0;
            species.water.air_resistance_spm = 0.0;
            continue;
        }
        species.water.conductance_mps =
            forest::canopy_conductance_mps(lai, parameters.min_conductance_mps,
                                           parameters.max_conductance_mps, parameters.full_conductance_lai) *
            (species.canopy.lai / lai) * f.physiology * f.temperature_of_conductance * f.co2_conductance;
        const double free_spm = 1.0 / parameters.boundary_layer_mps;
        const double relative = species.sizes.height_m / (0.5 * tallest_m);
        species.water.air_resistance_spm = species.sizes.height_m == tallest_m
                                               ? free_spm
                                               : free_spm + (air_resistance_per_lai_spm * lai - free_spm) *
                                                                config::exp2_of(-relative * relative);
    }
}

/// The month as species i meets it.
forest::EvaporationDay day_of(const Stand& stand, const Inputs& inputs, const ClimateMonth& month,
                              std::size_t i, double share_of_light, double vpd_kpa) {
    return {
        static_cast<double>(forest::days_in_month(month.when.month)), stand.day_length_s,
        share_of_light * inputs.parameters[i].net_radiation.by_day(month.radiation_mjpm2, stand.day_length_s),
        vpd_kpa};
}

void transpire_as_one_canopy(Stand& stand, const Inputs& inputs, const ClimateMonth& month) {
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        Water& water = stand.species[i].water;
        const forest::EvaporationDay day = day_of(stand, inputs, month, i, 1.0, water.vpd_kpa);
        // Without deficit there is none, whatever the radiation: so in r3PG.
        water.transpiration_mm =
            month.vpd_kpa == 0.0
                ? 0.0
                : std::max(0.0, forest::evaporation_mm(day, water.conductance_mps,
                                                       inputs.parameters[i].boundary_layer_mps));
    }
    stand.water.soil_evaporation_mm = 0.0;
}

void transpire_by_species(Stand& stand, const Inputs& inputs, const ClimateMonth& month) {
    double absorbed_share = 0.0;
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        SpeciesMonth& species = stand.species[i];
        absorbed_share += species.canopy.absorbed_share;
        const forest::EvaporationDay day =
            day_of(stand, inputs, month, i, species.canopy.absorbed_share, species.water.vpd_kpa);
        species.water.transpiration_mm = species.canopy.lai == 0.0
                                             ? 0.0
                                             : forest::evaporation_mm(day, species.water.conductance_mps,
                                                                      1.0 / species.water.air_resistance_spm);
    }
    const double lai = total_lai(stand);
    const double soil_vpd_kpa = month.vpd_kpa * config::exp2_of(-lai / soil_vpd_halving_lai);
    const forest::EvaporationDay day = day_of(stand, inputs, month, 0, 1.0 - absorbed_share, soil_vpd_kpa);
    stand.water.soil_evaporation_mm = forest::evaporation_mm(
        day, stand.water.soil_conductance_mps, lai > 0.0 ? 1.0 / (air_resistance_per_lai_spm * lai) : 1.0);
}

double intercept(Stand& stand, const Inputs& inputs, double prec_mm) {
    const double lai = total_lai(stand);
    double sum_mm = 0.0;
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const forest::Interception& law = inputs.parameters[i].interception;
        Water& water = stand.species[i].water;
        const double share_of_lai = lai > 0.0 ? stand.species[i].canopy.lai / lai : 0.0;
        water.interception_share = forest::interception_share(lai, law.max_share, law.full_lai) *
                                   (law.full_lai > 0.0 ? share_of_lai : 1.0);
        water.interception_mm = prec_mm * water.interception_share;
        sum_mm += water.interception_mm;
    }
    return sum_mm;
}

/// Fills and empties the soil; the share of the demand that it could meet.
double fill_bucket(StandWater& water, const Site& site, double prec_mm, double demand_mm) {
    const double least_mm = std::min(site.min_water_mm, site.max_water_mm);
    const double wet_mm = water.soil_mm + prec_mm;
    water.evapotranspiration_mm = std::min(wet_mm, demand_mm);
    water.runoff_mm = std::max(wet_mm - water.evapotranspiration_mm - site.max_water_mm, 0.0);
    water.soil_mm = wet_mm - water.evapotranspiration_mm - water.runoff_mm;
    water.irrigation_mm = std::max(least_mm - water.soil_mm, 0.0);
    water.soil_mm += water.irrigation_mm;
    return demand_mm == 0.0 ? 1.0 : water.evapotranspiration_mm / demand_mm;
}

/// What the soil could not give is taken off production and transpiration; interception falls before either.
void reduce_to_supply(Stand& stand, double transpiration_mm, double intercepted_mm) {
    StandWater& water = stand.water;
    const double left = transpiration_mm > 0.0 && water.supply < 1.0
                            ? (water.evapotranspiration_mm - intercepted_mm) / transpiration_mm
                            : 1.0;
    water.soil_evaporation_mm *= left;
    for (SpeciesMonth& species : stand.species) {
        species.production.gpp *= water.supply;
        species.production.npp *= water.supply;
        species.water.transpiration_mm *= left;
    }
}

}  // namespace

void balance_water(Stand& stand, const Inputs& inputs, const ClimateMonth& month, TranspirationModel model) {
    stand.water.soil_conductance_mps =
        wet_soil_conductance_mps * stand.water.soil_mm / inputs.site.max_water_mm;
    set_conductances(stand, inputs);
    if (model == TranspirationModel::by_species) {
        transpire_by_species(stand, inputs, month);
    } else {
        transpire_as_one_canopy(stand, inputs, month);
    }
    double transpiration_mm = stand.water.soil_evaporation_mm;
    for (const SpeciesMonth& species : stand.species) {
        transpiration_mm += species.water.transpiration_mm;
    }
    const double intercepted_mm = intercept(stand, inputs, month.prec_mm);
    stand.water.supply =
        fill_bucket(stand.water, inputs.site, month.prec_mm, transpiration_mm + intercepted_mm);
    reduce_to_supply(stand, transpiration_mm, intercepted_mm);
}

}  // namespace coupling::validation::forest_cases::plain_3pg
