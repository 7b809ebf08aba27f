#include "forest/production/water_balance.hpp"

#include <algorithm>
#include <cassert>

#include "forest/climate/calendar.hpp"
#include "forest/production/power.hpp"
#include "forest/production/snow.hpp"
#include "forest/production/three_pg_modifiers.hpp"

namespace forest {

namespace {

constexpr double free_boundary_layer_mps = 0.2;      // above the canopy [Landsberg & Waring 1997]
constexpr double wet_soil_conductance_mps = 0.0025;  // Forrester & Tang 2016
constexpr double air_resistance_per_lai_spm = 5.0;   // the same
constexpr double soil_vpd_halving_lai = 5.0;         // the same
constexpr double sealing_snow_mm = 20.0;

/// Weather does not change within these parts of a month; the soil dries from one to the next.
constexpr int parts_of_month = 4;

/// What a canopy of several species does together.
struct CanopyWater {
    double lai = 0.0;
    double interception_share = 0.0;
};

CanopyWater canopy_of(std::span<const WaterUse> uses, std::span<const double> lai) {
    CanopyWater canopy;
    for (const double own : lai) {
        canopy.lai += own;
    }
    for (std::size_t s = 0; s < uses.size(); ++s) {
        if (lai[s] > 0.0) {
            canopy.interception_share +=
                lai[s] / canopy.lai *
                interception_share(canopy.lai, uses[s].interception.max_share, uses[s].interception.full_lai);
        }
    }
    return canopy;
}

/// Conductance of a canopy whose stomata are as open as `open_at` says of each species.
template <class Opening>
double conductance_mps(std::span<const WaterUse> uses, std::span<const double> lai, double whole_lai,
                       Opening open_at) {
    double sum_mps = 0.0;
    for (std::size_t s = 0; s < uses.size(); ++s) {
        if (lai[s] > 0.0) {  // most patches have two or three of the species
            sum_mps += lai[s] / whole_lai * uses[s].limit * open_at(s) *
                       canopy_conductance_mps(whole_lai, 0.0, uses[s].max_conductance_mps,
                                              uses[s].full_conductance_lai);
        }
    }
    return sum_mps;
}

/// Evaporation from crowns and from the ground in some days, by conductance and filling of the soil.
class Evaporation {
public:
    Evaporation(const EvaporationDay& day, double lai, double ground_light) : crowns_{day}, ground_{day} {
        crowns_.net_radiation_wpm2 *= 1.0 - ground_light;
        ground_.net_radiation_wpm2 *= ground_light;
        ground_.vpd_kpa *= config::exp2_of(-lai / soil_vpd_halving_lai);
        // The air below crowns is the stiller, the more leaves are above; without them as free as above a
        // canopy.
        ground_boundary_mps_ =
            1.0 / std::max(air_resistance_per_lai_spm * lai, 1.0 / free_boundary_layer_mps);
    }
    [[nodiscard]] double from_crowns_mm(double conductance) const {
        return std::max(0.0, evaporation_mm(crowns_, conductance, free_boundary_layer_mps));
    }
    [[nodiscard]] double from_soil_mm(double filling) const {
        return std::max(0.0,
                        evaporation_mm(ground_, wet_soil_conductance_mps * filling, ground_boundary_mps_));
    }

private:
    EvaporationDay crowns_;
    EvaporationDay ground_;
    double ground_boundary_mps_ = free_boundary_layer_mps;
};

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
            vpd_modifier(climate.vpd_kpa, law.vpd_sensitivity_pmbar) *
                conductance_temperature_modifier(climate.tave_degc, climate.tmax_degc, law.temperature) *
                age * co2_conductance_modifier(co2_ppm, law.conductance_at_700),
            species.response.min_potential_mpa, law.interception};
}

WaterFlows balance_month(WaterState& state, const WaterMonth& month, const WaterStore& store,
                         std::span<const WaterUse> uses, std::span<const double> lai, double ground_light,
                         std::span<double> response) {
    assert(uses.size() == lai.size() && uses.size() == response.size());
    assert(store.capacity_mm > 0.0);
    constexpr double part = 1.0 / parts_of_month;
    const CanopyWater canopy = canopy_of(uses, lai);
    WaterFlows flows;
    flows.interception_mm = (month.rain_mm + month.snow_mm) * canopy.interception_share;
    const double through = 1.0 - canopy.interception_share;
    const double pack_mm = state.snow_mm + month.snow_mm * through;
    const double melt_mm = std::min(pack_mm, month.melt_capacity_mm);
    state.snow_mm = pack_mm - melt_mm;
    const double into_soil_mm = month.rain_mm * through + melt_mm;
    const bool is_open = state.snow_mm <= sealing_snow_mm && month.day.day_length_s > 0.0;
    const Evaporation evaporation{month.day, canopy.lai, ground_light};

    std::fill(response.begin(), response.end(), 0.0);
    double asked_mm = 0.0;
    for (int i = 0; i < parts_of_month; ++i) {
        state.soil_mm += part * into_soil_mm;
        const double filling = std::min(1.0, state.soil_mm / store.capacity_mm);
        const double potential = potential_mpa(store.potential, filling);
        const auto open_at = [&](std::size_t s) {
            return water_response(potential, uses[s].least_potential_mpa);
        };
        for (std::size_t s = 0; s < uses.size(); ++s) {
            response[s] += part * open_at(s);
        }
        if (is_open) {
            const double conductance = conductance_mps(uses, lai, canopy.lai, open_at);
            const double crowns_mm = part * evaporation.from_crowns_mm(conductance);
            const double ground_mm = part * evaporation.from_soil_mm(filling);
            const double wanted_mm = crowns_mm + ground_mm;
            const double met = wanted_mm > state.soil_mm ? state.soil_mm / wanted_mm : 1.0;
            asked_mm += wanted_mm;
            flows.transpiration_mm += met * crowns_mm;
            flows.soil_evaporation_mm += met * ground_mm;
            state.soil_mm = std::max(0.0, state.soil_mm - met * wanted_mm);
        }
        const double over_mm = std::max(0.0, state.soil_mm - store.capacity_mm);
        flows.runoff_mm += over_mm;
        state.soil_mm -= over_mm;
    }
    flows.evapotranspiration_mm = flows.interception_mm + flows.transpiration_mm + flows.soil_evaporation_mm;
    asked_mm += flows.interception_mm;
    flows.supply = asked_mm > 0.0 ? flows.evapotranspiration_mm / asked_mm : 1.0;
    flows.demand_mm = flows.interception_mm;
    if (is_open) {
        const double open_mps =
            conductance_mps(uses, lai, canopy.lai, [](std::size_t /*species*/) { return 1.0; });
        flows.demand_mm += evaporation.from_crowns_mm(open_mps) + evaporation.from_soil_mm(1.0);
    }
    return flows;
}

void DroughtSum::add(double tave_degc, const WaterFlows& flows) {
    if (counts(tave_degc)) {
        demand_mm_ += flows.demand_mm;
        met_mm_ += flows.evapotranspiration_mm;
    }
}

}  // namespace forest
