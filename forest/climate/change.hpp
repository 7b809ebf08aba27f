#pragma once

#include <array>
#include <string>

#include "config/table/table.hpp"
#include "forest/climate/series.hpp"

namespace forest {

/// The month (1-12) with every temperature shifted.
///
/// Relative humidity stays, so the deficit follows saturation pressure at the maximum temperature. Frost days
/// and degree-days shift as if days scattered normally around their mean (`daily_scatter_k`).
ClimateMonth warmed(const ClimateMonth& climate, int month, double shift_k);

/// Change of climate with elevation, by month.
struct LapseRates {
    std::array<double, 12> temperature_kpm{};     ///< K per metre upwards
    std::array<double, 12> precipitation_mmpm{};  ///< mm a month per metre upwards

    /// Reads month,temperature (K/100m),precipitation (mm/100m/month). Throws InputError (data).
    static LapseRates read(const config::Table& table);
    /// Swiss Alps, config/data/lapse_rates.csv.
    static LapseRates shipped();
};

/// A simple change of climate, by month.
struct ClimateChange {
    std::array<double, 12> temperature_k{};  ///< added
    std::array<double, 12> precipitation{1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
                                         1.0, 1.0, 1.0, 1.0, 1.0, 1.0};  ///< factor [-]

    /// The same change in all months.
    static ClimateChange of(double temperature_k, double precipitation);
    /// A part of the change, for a climate on its way there: 0 none, 1 all.
    [[nodiscard]] ClimateChange scaled(double share) const;
};

ClimateYear changed(const ClimateYear& year, const ClimateChange& change);

/// What a step up (or down) does to the climate of a series: temperatures by their lapse rates; precipitation
/// by a factor a month that gives its mean the millimetres of the lapse rate, so that a dry month stays dry
/// (down to none); radiation unchanged [choice].
ClimateChange change_with_elevation(const ClimateSeries& series, double difference_m,
                                    const LapseRates& rates);

/// The series at another elevation.
ClimateSeries at_elevation(const ClimateSeries& series, double difference_m, const LapseRates& rates);

}  // namespace forest
