#include "coupling/inputs/plausible/climate_at.hpp"

#include <cmath>
#include <numeric>

namespace coupling::plausible {

ClimateAt climate_at(const forest::ClimateSeries& series, double latitude_deg, double elevation_m,
                     const forest::LapseRates& rates) {
    const forest::ClimateSeries here = at_elevation(series, elevation_m - *series.elevation_m, rates);
    ClimateAt climate{.latitude_deg = latitude_deg, .elevation_m = elevation_m};
    const auto years = static_cast<double>(here.years.size());
    for (const forest::ClimateYear& year : here.years) {
        for (const forest::ClimateMonth& month : year.months) {
            climate.mean_degc += month.tave_degc / (12.0 * years);
        }
        climate.january_degc += year.months[0].tave_degc / years;
        climate.july_degc += year.months[6].tave_degc / years;
    }
    return climate;
}

double usual_mean_degc(double latitude_deg, double elevation_m) {
    return 30.0 - 0.4 * latitude_deg - 0.0055 * elevation_m;
}

bool is_of_another_place(const ClimateAt& climate) {
    constexpr double far_k = 9.0;
    return std::abs(climate.mean_degc - usual_mean_degc(climate.latitude_deg, climate.elevation_m)) > far_k;
}

bool has_seasons_of_other_half(const ClimateAt& climate) {
    constexpr double from_deg = 20.0;
    constexpr double clear_k = 3.0;
    return climate.latitude_deg >= from_deg && climate.january_degc - climate.july_degc > clear_k;
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
