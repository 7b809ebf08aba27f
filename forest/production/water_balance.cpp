#include "forest/production/water_balance.hpp"

#include <algorithm>
#include <cassert>

#include "forest/production/calendar.hpp"
#include "forest/production/power.hpp"
#include "forest/production/snow.hpp"

namespace forest {

namespace {

constexpr double free_boundary_layer_mps = 0.2;      // above the canopy [Landsberg & Waring 1997]
constexpr double wet_soil_conductance_mps = 0.0025;  // Forrester & Tang 2016
constexpr double air_resistance_per_lai_spm = 5.0;   // the same
constexpr double soil_vpd_halving_lai = 5.0;         // the same
constexpr double sealing_snow_mm = 20.0;

/// What a canopy of several species does together.
struct CanopyWater {
    double lai = 0.0;
    double interception_share = 0.0;
    double conductance_mps = 0.0;
};

CanopyWater canopy_of(std::span<const WaterUse> uses, std::span<const double> lai,
                      double soil_water_modifier) {
    CanopyWater canopy;
    for (const double own : lai) {
        canopy.lai += own;
    }
    if (canopy.lai <= 0.0) {
        return canopy;
    }
    for (std::size_t s = 0; s < uses.size(); ++s) {
        if (lai[s] == 0.0) {
            continue;  // most patches have two or three of the species
        }
        const WaterUse& use = uses[s];
        const double share = lai[s] / canopy.lai;
        canopy.interception_share +=
            share * interception_share(canopy.lai, use.interception.max_share, use.interception.full_lai);
        canopy.conductance_mps +=
            share * use.limit * soil_water_modifier *
            canopy_conductance_mps(canopy.lai, 0.0, use.max_conductance_mps, use.full_conductance_lai);
    }
    return canopy;
}

double transpiration_mm(const EvaporationDay& day, const CanopyWater& canopy, double ground_light) {
    EvaporationDay in_crowns = day;
    in_crowns.net_radiation_wpm2 *= 1.0 - ground_light;
    return std::max(0.0, evaporation_mm(in_crowns, canopy.conductance_mps, free_boundary_layer_mps));
}

double soil_evaporation_mm(const EvaporationDay& day, double lai, double filling, double ground_light) {
    EvaporationDay at_ground = day;
    at_ground.net_radiation_wpm2 *= ground_light;
    at_ground.vpd_kpa *= config::exp2_of(-lai / soil_vpd_halving_lai);
    // The air below crowns is the stiller, the more leaves are above; without them as free as above a canopy.
    const double boundary_mps =
        1.0 / std::max(air_resistance_per_lai_spm * lai, 1.0 / free_boundary_layer_mps);
    return std::max(0.0, evaporation_mm(at_ground, wet_soil_conductance_mps * filling, boundary_mps));
}

}  // namespace

WaterMonth water_month(const ClimateMonth& climate, int month, double day_length_s, double slope_radiation) {
    const double days = days_in_month(month);
    const double snow = snow_share(climate.tave_degc);
    const double net_wpm2 =
        day_length_s > 0.0 ? NetRadiation{}.by_day(climate.radiation_mjpm2 * slope_radiation, day_length_s)
                           : 0.0;
    return {{days, day_length_s, net_wpm2, climate.vpd_kpa},
            climate.prec_mm * (1.0 - snow),
            climate.prec_mm * snow,
            melt_capacity_mm(climate.tave_degc, days)};
}

WaterUse water_use(const Species& species, const ClimateMonth& climate, double age, double co2_ppm) {
    const ThreePg& law = species.three_pg;
    return {law.max_conductance_mps, law.full_conductance_lai,
            vpd_modifier(climate.vpd_kpa, law.vpd_sensitivity_pmbar) * age *
                co2_conductance_modifier(co2_ppm, law.conductance_at_700),
            law.interception};
}

WaterFlows balance_month(WaterState& state, const WaterMonth& month, const WaterStore& store,
                         std::span<const WaterUse> uses, std::span<const double> lai, double ground_light) {
    assert(uses.size() == lai.size());
    assert(store.capacity_mm > 0.0);
    WaterFlows flows;
    const double filling = state.soil_mm / store.capacity_mm;
    flows.soil_water_modifier = soil_water_modifier(filling, store.curve);
    const CanopyWater canopy = canopy_of(uses, lai, flows.soil_water_modifier);

    flows.interception_mm = (month.rain_mm + month.snow_mm) * canopy.interception_share;
    const double through = 1.0 - canopy.interception_share;
    const double pack_mm = state.snow_mm + month.snow_mm * through;
    const double melt_mm = std::min(pack_mm, month.melt_capacity_mm);
    state.snow_mm = pack_mm - melt_mm;
    state.soil_mm += month.rain_mm * through + melt_mm;

    double from_crowns_mm = 0.0;
    double from_soil_mm = 0.0;
    if (state.snow_mm <= sealing_snow_mm && month.day.day_length_s > 0.0) {
        from_crowns_mm = transpiration_mm(month.day, canopy, ground_light);
        from_soil_mm = soil_evaporation_mm(month.day, canopy.lai, filling, ground_light);
    }
    const double from_store_mm = from_crowns_mm + from_soil_mm;
    const double met = from_store_mm > state.soil_mm ? state.soil_mm / from_store_mm : 1.0;
    flows.transpiration_mm = met * from_crowns_mm;
    flows.soil_evaporation_mm = met * from_soil_mm;
    flows.evapotranspiration_mm = flows.interception_mm + flows.transpiration_mm + flows.soil_evaporation_mm;
    flows.demand_mm = flows.interception_mm + from_store_mm;
    flows.supply = flows.demand_mm > 0.0 ? flows.evapotranspiration_mm / flows.demand_mm : 1.0;

    state.soil_mm = std::max(0.0, state.soil_mm - flows.transpiration_mm - flows.soil_evaporation_mm);
    flows.runoff_mm = std::max(0.0, state.soil_mm - store.capacity_mm);
    state.soil_mm -= flows.runoff_mm;
    return flows;
}

void DroughtSum::add(double tave_degc, const WaterFlows& flows) {
    constexpr double growth_degc = 5.5;
    if (tave_degc > growth_degc) {
        demand_mm_ += flows.demand_mm;
        met_mm_ += flows.evapotranspiration_mm;
    }
}

}  // namespace forest
