#include "coupling/inputs/plausible/climate_at.hpp"

#include <cmath>
#include <numeric>

namespace coupling::plausible {

ClimateAt means_of(const forest::ClimateSeries& series, double latitude_deg) {
    ClimateAt climate{.latitude_deg = latitude_deg, .elevation_m = series.elevation_m.value_or(0.0)};
    const auto years = static_cast<double>(series.years.size());
    for (const forest::ClimateYear& year : series.years) {
        for (const forest::ClimateMonth& month : year.months) {
            climate.mean_degc += month.tave_degc / (12.0 * years);
        }
        climate.january_degc += year.months[0].tave_degc / years;
        climate.july_degc += year.months[6].tave_degc / years;
    }
    return climate;
}

ClimateAt climate_at(const forest::ClimateSeries& series, double latitude_deg, double elevation_m,
                     const forest::LapseRates& rates) {
    ClimateAt climate =
        means_of(at_elevation(series, elevation_m - *series.elevation_m, rates), latitude_deg);
    climate.elevation_m = elevation_m;
    return climate;
}

double usual_mean_degc(double latitude_deg, double elevation_m) {
    return 30.0 - 0.4 * latitude_deg - 0.0055 * elevation_m;
}

bool is_of_another_place(const ClimateAt& climate) {
    constexpr double far_k = 9.0;
    return std::abs(climate.mean_degc - usual_mean_degc(climate.latitude_deg, climate.elevation_m)) > far_k;
}

bool seasons_contradict(const Hemisphere& at) {
    if (std::abs(at.latitude_deg) < at.from_deg) {
        return false;
    }
    const double summer_minus_winter = at.latitude_deg > 0.0 ? at.july - at.january : at.january - at.july;
    return summer_minus_winter < -at.clear;
}

Hemisphere hemisphere_of(const ClimateAt& climate) {
    return {.latitude_deg = climate.latitude_deg,
            .january = climate.january_degc,
            .july = climate.july_degc,
            .clear = 3.0};
}

bool is_far_from_species(double latitude_deg) {
    return latitude_deg < 30.0 || latitude_deg > 70.0;
}

double mean_factor_on_rain(const forest::ClimateChange& change) {
    return std::accumulate(change.precipitation.begin(), change.precipitation.end(), 0.0) / 12.0;
}

bool is_odd_factor_on_rain(double factor) {
    return factor < 0.5 || factor > 1.5;
}

}  // namespace coupling::plausible
