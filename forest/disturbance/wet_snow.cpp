#include "forest/disturbance/wet_snow.hpp"

#include <algorithm>

#include "forest/climate/normal.hpp"

namespace forest {

double wet_snow_mm(const ClimateYear& year) {
    constexpr double coldest_degc = -0.5;
    constexpr double warmest_degc = 1.5;
    double sum_mm = 0.0;
    for (const std::size_t month : {0U, 1U, 11U}) {
        const ClimateMonth& climate = year.months[month];
        sum_mm +=
            climate.prec_mm * (normal_probability((warmest_degc - climate.tave_degc) / daily_scatter_k) -
                               normal_probability((coldest_degc - climate.tave_degc) / daily_scatter_k));
    }
    return sum_mm;
}

double wet_snow_chance(const ClimateYear& year, double usual_chance) {
    return std::min(1.0, usual_chance * wet_snow_mm(year) / usual_wet_snow_mm);
}

}  // namespace forest
