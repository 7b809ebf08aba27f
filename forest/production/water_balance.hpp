#pragma once

#include <span>

#include "forest/climate/series.hpp"
#include "forest/production/soil_potential.hpp"
#include "forest/production/transpiration.hpp"
#include "forest/stand/species.hpp"

namespace forest {

// The water of one patch and month [mm on the map]: snow, interception, transpiration, soil evaporation and a
// bucket of what roots can take. Landsberg & Waring 1997; soil evaporation and the sharing of radiation
// between crowns and ground after Forrester & Tang 2016.

/// Weather of a month, shared by all patches of a site unit.
struct WaterMonth {
    EvaporationDay day;  ///< with the net radiation of the slope
    double rain_mm = 0.0;
    double snow_mm = 0.0;
    double melt_capacity_mm = 0.0;
};

/// `slope_radiation` is the month's radiation on the slope per area on the map over that on the flat [-].
WaterMonth water_month(const ClimateMonth& climate, int month, double day_length_s, double slope_radiation);

/// What a species asks of water in a month and site unit; made once for its patches.
struct WaterUse {
    double max_conductance_mps = 0.0;
    double full_conductance_lai = 0.0;
    double limit = 0.0;                 ///< modifier of conductance but for soil water [-]
    double least_potential_mpa = -1.0;  ///< of the soil, at which stomata are closed
    Interception interception;
};

/// Limits by vapour pressure deficit, temperature, age and CO2 at once: those of 3-PGmix, with which the
/// greatest conductances of the species were fitted [Forrester & Tang 2016].
WaterUse water_use(const Species& species, const ClimateMonth& climate, double age_modifier, double co2_ppm);

/// Water storage of the soil of a patch.
struct WaterStore {
    double capacity_mm = 0.0;  ///< above 0
    SoilPotential potential;
};

/// Water of a patch.
struct WaterState {
    double soil_mm = 0.0;  ///< that roots can take, [0, capacity]
    double snow_mm = 0.0;  ///< water in the snow
};

/// Where the water of the month went. Rain and snow = evapotranspiration + runoff + change of soil and snow
/// water.
struct WaterFlows {
    double interception_mm = 0.0;
    double transpiration_mm = 0.0;
    double soil_evaporation_mm = 0.0;
    double evapotranspiration_mm = 0.0;  ///< the three together
    double runoff_mm = 0.0;
    double demand_mm =
        0.0;  ///< evapotranspiration with the soil at capacity: no stomata closed for want of water
    double supply = 1.0;  ///< evapotranspiration / what the stomata asked for [-]; 1 if for nothing
};

/// Moves the water of one month, in four parts of equal weather.
///
/// `lai` holds the leaf area index of each species of `uses`, 0 while its leaves are off. `ground_light` is
/// the share of light that reaches the ground [0, 1]: soil evaporation has that share of net radiation, the
/// crowns the rest. `response` receives the mean opening of the stomata of each species [0, 1]
/// (water_response), also of those without leaves. Stomata of each species close by its own threshold, and
/// all species drink from one store. Under more than 20 mm of snow nothing transpires or evaporates from the
/// soil [choice].
WaterFlows balance_month(WaterState& state, const WaterMonth& month, const WaterStore& store,
                         std::span<const WaterUse> uses, std::span<const double> lai, double ground_light,
                         std::span<double> response);

/// Demand and supply of the months that are warm enough for growth, for the drought of a year.
class DroughtSum {
public:
    /// Whether a month of this mean counts: above 5.5 degC.
    static bool counts(double tave_degc) { return tave_degc > 5.5; }
    /// Counts a month if it is warm enough.
    void add(double tave_degc, const WaterFlows& flows);
    /// Share of the demand that was not met [0, 1]; 0 without demand.
    [[nodiscard]] double index() const { return demand_mm_ > 0.0 ? 1.0 - met_mm_ / demand_mm_ : 0.0; }

private:
    double demand_mm_ = 0.0;
    double met_mm_ = 0.0;
};

}  // namespace forest
