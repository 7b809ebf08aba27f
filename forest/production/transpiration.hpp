#pragma once

namespace forest {

// Penman-Monteith in the form of 3-PG, on monthly means of daytime (Landsberg & Gower 1997; Landsberg &
// Waring 1997; per species Forrester & Tang 2016).

/// The day on which water evaporates.
struct EvaporationDay {
    double days = 0.0;          ///< in the month
    double day_length_s = 0.0;  ///< daylight
    double net_radiation_wpm2 = 0.0;
    double vpd_kpa = 0.0;
};

/// Net radiation [W/m2] in daylight by the solar radiation [MJ/m2/d]; the line may go below 0.
struct NetRadiation {
    double intercept_wpm2 = -90.0;
    double slope = 0.8;

    [[nodiscard]] double by_day(double radiation_mjpm2, double day_length_s) const {
        return intercept_wpm2 + slope * (radiation_mjpm2 * 1e6 / day_length_s);
    }
};

/// Water that evaporates from a surface of the given conductance in a month [mm]; may be below 0 where net
/// radiation is.
///
/// Requires a boundary-layer conductance above 0.
double evaporation_mm(const EvaporationDay& day, double conductance_mps, double boundary_layer_mps);

/// Conductance of a canopy [m/s] at a leaf area index: rises with it up to `full_lai`.
double canopy_conductance_mps(double lai, double min_mps, double max_mps, double full_lai);

/// Share of the rain that stays in a canopy of total leaf area `lai` [-]; constant where full_lai is 0.
double interception_share(double lai, double max_share, double full_lai);

}  // namespace forest
