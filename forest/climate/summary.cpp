#include "forest/climate/summary.hpp"

#include <algorithm>

#include "forest/climate/calendar.hpp"
#include "forest/climate/normal.hpp"

namespace forest {

namespace {

constexpr double growth_base_degc = 5.5;
constexpr double days_per_year = 365.0;

double lowest_of(const ClimateMonth& month) {
    return month.abs_tmin_degc.value_or(month.tmin_degc - 3.0 * daily_scatter_k);
}

}  // namespace

double degree_days(const ClimateMonth& climate, int month, double base_degc) {
    if (climate.degree_days && base_degc == growth_base_degc) {
        return *climate.degree_days;
    }
    return days_in_month(month) * mean_above(climate.tave_degc, base_degc, daily_scatter_k);
}

double degree_days(const ClimateYear& year, double base_degc) {
    double sum = 0.0;
    for (int month = 1; month <= 12; ++month) {
        sum += degree_days(year.months[static_cast<std::size_t>(month - 1)], month, base_degc);
    }
    return sum;
}

ClimateSummary summary_of(const ClimateYear& year) {
    ClimateSummary summary;
    summary.coldest_month_degc = year.months.front().tave_degc;
    summary.lowest_degc = lowest_of(year.months.front());
    summary.degree_days = degree_days(year);
    summary.frost_free_days = days_per_year;
    for (int month = 1; month <= 12; ++month) {
        const ClimateMonth& climate = year.months[static_cast<std::size_t>(month - 1)];
        const double days = days_in_month(month);
        summary.mean_degc += climate.tave_degc * days / days_per_year;
        summary.prec_mm += climate.prec_mm;
        summary.coldest_month_degc = std::min(summary.coldest_month_degc, climate.tave_degc);
        summary.lowest_degc = std::min(summary.lowest_degc, lowest_of(climate));
        summary.growing_season_days +=
            days * normal_probability((climate.tave_degc - growth_base_degc) / daily_scatter_k);
        summary.frost_free_days -= climate.frost_days;
        if (climate.tave_degc > growth_base_degc) {
            summary.first_growing_month =
                summary.first_growing_month == 0 ? month : summary.first_growing_month;
            summary.last_growing_month = month;
        }
    }
    return summary;
}

}  // namespace forest
