#pragma once

#include "forest/climate/series.hpp"

namespace forest {

/// Degree-days of a month above a base, from its mean and a normal scatter of days (`daily_scatter_k`).
double degree_days(const ClimateMonth& climate, int month, double base_degc);

/// Degree-days of a year above a base; where the series has its own at 5.5 degC and that is the base, these.
double degree_days(const ClimateYear& year, double base_degc = 5.5);

/// What a year was like, as limits of species ask for it.
struct ClimateSummary {
    double mean_degc = 0.0;
    double prec_mm = 0.0;
    double degree_days = 0.0;         ///< above 5.5 degC
    double coldest_month_degc = 0.0;  ///< mean of the coldest month
    double lowest_degc =
        0.0;  ///< lowest minimum: as given, else three scatters below the coldest mean minimum
    double growing_season_days = 0.0;  ///< days to be expected with a mean above 5.5 degC
    double frost_free_days = 0.0;      ///< days without frost
    int first_growing_month = 0;       ///< first month with a mean above 5.5 degC, 0 if there is none
    int last_growing_month = 0;
};

ClimateSummary summary_of(const ClimateYear& year);

}  // namespace forest
