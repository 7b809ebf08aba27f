#include "forest/production/three_pg_modifiers.hpp"

#include <algorithm>

#include "forest/production/power.hpp"

namespace forest {

namespace {

constexpr double reference_co2_ppm = 350.0;
constexpr double mbar_per_kpa = 10.0;

}  // namespace

double temperature_modifier(double mean_degc, const TemperatureCurve& curve) {
    if (mean_degc <= curve.min_degc || mean_degc >= curve.max_degc) {
        return 0.0;
    }
    const double rise = curve.optimum_degc - curve.min_degc;
    const double fall = curve.max_degc - curve.optimum_degc;
    return (mean_degc - curve.min_degc) / rise * power((curve.max_degc - mean_degc) / fall, fall / rise);
}

double conductance_temperature_modifier(double mean_degc, double mean_max_degc,
                                        const TemperatureCurve& curve) {
    return temperature_modifier(0.5 * (mean_degc + mean_max_degc), curve);
}

double frost_modifier(double frost_days, double days, double loss) {
    return 1.0 - loss * (frost_days / days);
}

double vpd_modifier(double vpd_kpa, double sensitivity_pmbar) {
    return config::exp_of(-sensitivity_pmbar * mbar_per_kpa * vpd_kpa);
}

SoilWaterCurve soil_water_curve(double soil_class) {
    return {0.8 - 0.1 * soil_class, 11.0 - 2.0 * soil_class};
}

double soil_water_modifier(double filling, const SoilWaterCurve& curve) {
    return 1.0 / (1.0 + power((1.0 - filling) / curve.half_deficit, curve.power));
}

double nutrition_modifier(double fertility, const NutritionCurve& curve) {
    return 1.0 - (1.0 - curve.at_zero) * power(1.0 - fertility, curve.power);
}

double co2_assimilation_modifier(double co2_ppm, double assimilation_at_700) {
    const double x = assimilation_at_700 / (2.0 - assimilation_at_700);
    return x * co2_ppm / (reference_co2_ppm * (x - 1.0) + co2_ppm);
}

double co2_conductance_modifier(double co2_ppm, double conductance_at_700) {
    const double g = conductance_at_700 / (2.0 * conductance_at_700 - 1.0);
    return g / (1.0 + (g - 1.0) * co2_ppm / reference_co2_ppm);
}

double age_modifier(double age_years, const AgeCurve& curve) {
    if (curve.power == 0.0) {
        return 1.0;
    }
    return 1.0 / (1.0 + power(age_years / curve.max_years / curve.relative_half, curve.power));
}

double physiological_modifier(double vpd, double soil_water, double age, Physiology physiology) {
    return (physiology == Physiology::scarcer ? std::min(vpd, soil_water) : vpd * soil_water) * age;
}

double ph_modifier(double ph, double min_optimum_ph) {
    constexpr double width = 0.8;   // pH units from the optimum to nothing [choice]
    constexpr double lowest = 0.3;  // [choice]
    return std::clamp((ph - min_optimum_ph + width) / width, lowest, 1.0);
}

}  // namespace forest
