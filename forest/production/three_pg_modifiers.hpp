#pragma once

#include "forest/stand/species.hpp"

namespace forest {

// What the site takes from production: the modifiers of 3-PG, each on [0, 1] unless said otherwise.
// Landsberg & Waring 1997 (For. Ecol. Manage. 95:209-228); Sands & Landsberg 2002 (For. Ecol. Manage.
// 163:273-292); Forrester & Tang 2016 (Ecol. Modell. 319:233-254).

/// Growth at a monthly mean temperature: 1 at the optimum, 0 at and outside the limits [Landsberg & Waring
/// 1997].
double temperature_modifier(double mean_degc, const TemperatureCurve& curve);

/// Conductance of stomata at the temperatures of a month: the curve of growth between the mean and the mean
/// of the daily maxima, since leaves transpire by day. Cold keeps stomata closed [3-PGmix; Forrester & Tang
/// 2016].
double conductance_temperature_modifier(double mean_degc, double mean_max_degc,
                                        const TemperatureCurve& curve);

/// 1 - loss * frost days / days; below 0 where a day of frost costs more than the month has [Landsberg &
/// Waring 1997].
double frost_modifier(double frost_days, double days, double loss);

/// exp(-sensitivity * deficit). The sensitivity is per millibar, as 3-PG has it, the deficit in kPa.
double vpd_modifier(double vpd_kpa, double sensitivity_pmbar);

/// How a soil gives its water.
struct SoilWaterCurve {
    double half_deficit = 0.0;  ///< share of the available water that is gone when growth has halved [-]
    double power = 0.0;         ///< [-]
};

/// The curve of a soil class: 1 sand, 2 sandy loam, 3 clay loam, 4 clay; parts of a class are fine [Landsberg
/// & Waring 1997].
SoilWaterCurve soil_water_curve(double soil_class);

/// Growth when `filling` of the available water is left [-].
double soil_water_modifier(double filling, const SoilWaterCurve& curve);

/// Growth at a fertility of 0 to 1.
double nutrition_modifier(double fertility, const NutritionCurve& curve);

/// Quantum efficiency at a CO2 concentration over that at 350 ppm; above 1 beyond 350 ppm [Forrester & Tang
/// 2016]. Requires assimilation_at_700 below 2.
double co2_assimilation_modifier(double co2_ppm, double assimilation_at_700);

/// Canopy conductance at a CO2 concentration over that at 350 ppm [Forrester & Tang 2016].
/// Requires conductance_at_700 above 0.5.
double co2_conductance_modifier(double co2_ppm, double conductance_at_700);

/// Decline with age.
double age_modifier(double age_years, const AgeCurve& curve);

/// How the limits of air and soil act together.
enum class Physiology {
    scarcer,  ///< the scarcer of both rules [3-PGpjs]
    product,  ///< both reduce [3-PGmix]
};

/// Modifier of quantum efficiency and conductance.
double physiological_modifier(double vpd, double soil_water, double age, Physiology physiology);

/// Share of an optimum fertility that the top soil's pH leaves [choice; PICUS has such an effect].
double ph_modifier(double ph, double min_optimum_ph);

}  // namespace forest
