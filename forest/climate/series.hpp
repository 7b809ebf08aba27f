#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/declared.hpp"
#include "config/table/table.hpp"

namespace forest {

/// Climate of a month.
struct ClimateMonth {
    double tmin_degc = 0.0;                 ///< mean of the daily minima
    double tmax_degc = 0.0;                 ///< mean of the daily maxima
    double tave_degc = 0.0;                 ///< mean
    double prec_mm = 0.0;                   ///< rain and snow, sum
    double radiation_mjpm2 = 0.0;           ///< global radiation of a mean day on flat ground
    double vpd_kpa = 0.0;                   ///< vapour pressure deficit, mean of daytime
    double frost_days = 0.0;                ///< with a minimum below 0 degC
    std::optional<double> degree_days{};    ///< sum above 5.5 degC, where daily values were known
    std::optional<double> abs_tmin_degc{};  ///< lowest minimum, where known
};

/// Climate of a year, January first.
struct ClimateYear {
    int year = 0;
    std::array<ClimateMonth, 12> months{};
};

/// Climate of one place: whole years in order, none left out.
struct ClimateSeries {
    std::optional<double> elevation_m{};  ///< of the place, where the table says so
    std::vector<ClimateYear> years;

    [[nodiscard]] int first_year() const { return years.front().year; }
    [[nodiscard]] int last_year() const { return years.back().year; }
    /// Nothing outside the series.
    [[nodiscard]] const ClimateYear* find(int year) const;
};

struct ClimateRow;
/// The columns of monthly climate. `by_day`: the deficit is called vpd_day_kpa.
const config::Schema<ClimateRow>& climate_columns(bool by_day);

/// Reads monthly climate. What is missing is made from temperatures: the mean as the middle of minimum and
/// maximum, the deficit after 3-PG, frost days with a normal scatter; each with a warning. Other columns are
/// read over, with a warning where the name is nearly one of these. Rows may stand in any order.
///
/// Throws one InputError (data) with file, line and column for all missing columns, values that are no
/// numbers or cannot be, months that are missing or stand twice, and for radiation in W/m2 and deficits in
/// hPa. What is only suspicious is a warning. A table that holds several elevations gives one series each,
/// lowest first.
std::vector<ClimateSeries> read_climate(const config::Table& table, config::Warnings& warnings);

/// The same for a table that must hold one place.
ClimateSeries read_climate_of_one_place(const config::Table& table, config::Warnings& warnings);

/// Frost days to be expected of a month with this mean of the daily minima.
double expected_frost_days(double tmin_degc, int month);

}  // namespace forest
