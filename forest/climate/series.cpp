#include "forest/climate/series.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/climate/climate_checks.hpp"
#include "forest/climate/normal.hpp"
#include "forest/climate/vapour.hpp"

namespace forest {

namespace {

using config::ExitCode;
using config::NumberRange;
using config::Problems;
using config::Table;

/// What no place on earth goes beyond; units other than ours are caught before.
constexpr NumberRange temperature_range{-80.0, 60.0};
constexpr NumberRange precipitation_range{0.0, 3000.0};
constexpr NumberRange radiation_range{0.0, 45.0};
constexpr NumberRange deficit_range{0.0, 12.0};
constexpr NumberRange degree_day_range{0.0, 1500.0};
constexpr NumberRange elevation_range{-500.0, 9000.0};

/// The name under which a table gives the daytime deficit; "" if it does not.
std::string_view deficit_column(const Table& table) {
    return table.has("vpd_kpa") ? "vpd_kpa" : table.has("vpd_day_kpa") ? "vpd_day_kpa" : "";
}

/// A number that a table may leave out, as a column or in single rows.
std::optional<double> optional_number(const Table& table, std::size_t row, std::string_view column,
                                      NumberRange range, Problems& problems) {
    if (column.empty() || !table.has(column) || table.text(row, column).empty()) {
        return std::nullopt;
    }
    return table.number(row, column, range, problems);
}

ClimateMonth read_month(const Table& table, std::size_t row, int month, Problems& problems) {
    const auto number = [&](std::string_view column, NumberRange range) {
        return table.number(row, column, range, problems).value_or(0.0);
    };
    const auto optional = [&](std::string_view column, NumberRange range) {
        return optional_number(table, row, column, range, problems);
    };
    ClimateMonth result;
    result.tmin_degc = number("tmin_c", temperature_range);
    result.tmax_degc = number("tmax_c", temperature_range);
    result.tave_degc =
        optional("tave_c", temperature_range).value_or(0.5 * (result.tmin_degc + result.tmax_degc));
    result.prec_mm = number("prec_mm", precipitation_range);
    result.radiation_mjpm2 = number("rad_mj_m2_d", radiation_range);
    result.vpd_kpa = optional(deficit_column(table), deficit_range)
                         .value_or(vpd_from_temperatures_kpa(result.tmin_degc, result.tmax_degc));
    result.frost_days = optional("frost_days", {0.0, month == 2 ? 29.0 : days_in_month(month) * 1.0})
                            .value_or(expected_frost_days(result.tmin_degc, month));
    result.degree_days = optional("gdd55_c_d", degree_day_range);
    result.abs_tmin_degc = optional("abs_tmin_c", temperature_range);
    return result;
}

/// A place and its months while they are collected.
struct Place {
    std::map<int, ClimateYear> years;
    std::map<std::pair<int, int>, std::size_t> rows;  ///< by year and month
};

void check_complete(const Place& place, const Table& table, const std::string& where, Problems& problems) {
    for (int year = place.years.begin()->first; year <= place.years.rbegin()->first; ++year) {
        if (!place.years.contains(year)) {
            problems.add(ExitCode::data, {table.file()}, "no year " + std::to_string(year) + where,
                         "every year from the first to the last");
            continue;
        }
        for (int month = 1; month <= 12; ++month) {
            if (!place.rows.contains({year, month})) {
                problems.add(ExitCode::data, {table.file()},
                             "no month " + std::to_string(month) + " of " + std::to_string(year) + where,
                             "twelve months in each year");
            }
        }
    }
}

/// Reads all rows into places by elevation; NaN never comes up, as places without elevation count as one.
std::map<double, Place> read_places(const Table& table, Problems& problems) {
    std::map<double, Place> places;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto year = table.whole(row, "year", {0.0, 9999.0}, problems);
        const auto month = table.whole(row, "month", {1.0, 12.0}, problems);
        const double elevation_m =
            table.has("elev_m") ? table.number(row, "elev_m", elevation_range, problems).value_or(0.0) : 0.0;
        if (!year || !month) {
            continue;
        }
        Place& place = places[elevation_m];
        const int y = static_cast<int>(*year);
        const int m = static_cast<int>(*month);
        const auto [before, fresh] = place.rows.emplace(std::pair{y, m}, row);
        if (!fresh) {
            problems.add(ExitCode::data, table.place(row, "month"),
                         "month " + std::to_string(m) + " of " + std::to_string(y) + " a second time",
                         "each month once (first in line " +
                             std::to_string(table.place(before->second, "month").line) + ")");
            continue;
        }
        ClimateYear& in = place.years[y];
        in.year = y;
        in.months[static_cast<std::size_t>(m - 1)] = read_month(table, row, m, problems);
    }
    return places;
}

/// Whether two names differ in what they measure, such as abs_tmax_c and abs_tmin_c, gdd5_c_d and gdd55_c_d.
bool is_other_quantity(const std::string& column, const std::string& name) {
    const auto digits = [](const std::string& text) {
        return std::count_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    const bool is_maximum = column.find("max") != std::string::npos;
    return is_maximum != (name.find("max") != std::string::npos) || digits(column) != digits(name);
}

/// Tables of stations have columns of their own, which are nobody's mistake; one that is nearly a column that
/// the table lacks is.
void warn_of_misspelt_columns(const Table& table, config::Warnings& warnings) {
    static constexpr std::array<std::string_view, 13> read{
        "year",    "month",       "tmin_c",     "tmax_c",    "prec_mm",    "rad_mj_m2_d", "tave_c",
        "vpd_kpa", "vpd_day_kpa", "frost_days", "gdd55_c_d", "abs_tmin_c", "elev_m"};
    std::vector<std::string> absent;
    for (const std::string_view name : read) {
        const bool is_other_deficit = name.starts_with("vpd") && !deficit_column(table).empty();
        if (!table.has(name) && !is_other_deficit) {
            absent.emplace_back(name);
        }
    }
    for (const std::string& column : table.columns_beside({read.begin(), read.end()})) {
        const std::string meant = config::nearest_word(column, absent);
        if (!meant.empty() && !is_other_quantity(column, meant)) {
            table.count_as_named(column);
            warnings.add(config::joined(table.file(), ": column ", config::in_quotes(column),
                                        " is not read; if it is ", config::in_quotes(meant),
                                        ", give it that name"));
        }
    }
}

void warn_of_what_was_made(const Table& table, config::Warnings& warnings) {
    if (!table.has("tave_c")) {
        warnings.add_note(table.file() + ": no column tave_c; the middle of minimum and maximum is taken");
    }
    if (deficit_column(table).empty()) {
        warnings.add_note(table.file() +
                          ": no column vpd_kpa; vapour pressure deficits are made from temperatures");
    }
    if (!table.has("frost_days")) {
        warnings.add_note(table.file() + ": no column frost_days; they are made from minimum temperatures");
    }
}

}  // namespace

const ClimateYear* ClimateSeries::find(int year) const {
    const auto found = std::lower_bound(years.begin(), years.end(), year,
                                        [](const ClimateYear& a, int wanted) { return a.year < wanted; });
    return found == years.end() || found->year != year ? nullptr : &*found;
}

std::vector<ClimateSeries> read_climate(const Table& table, config::Warnings& warnings) {
    Problems problems;
    table.require({"year", "month", "tmin_c", "tmax_c", "prec_mm", "rad_mj_m2_d"}, problems);
    if (problems.empty() && table.rows() == 0) {
        problems.add(ExitCode::data, {table.file()}, "no months", "at least twelve");
    }
    problems.throw_if_any();
    check_units_of_climate(table, "rad_mj_m2_d", deficit_column(table));

    const std::map<double, Place> places = read_places(table, problems);
    std::vector<ClimateSeries> result;
    for (const auto& [elevation_m, place] : places) {
        const bool several = places.size() > 1;
        check_complete(place, table, several ? " at " + config::to_text(elevation_m) + " m" : "", problems);
        ClimateSeries series;
        if (table.has("elev_m")) {
            series.elevation_m = elevation_m;
        }
        for (const auto& [year, months] : place.years) {
            series.years.push_back(months);
        }
        result.push_back(std::move(series));
        check_months(result.back(), table, place.rows, problems, warnings);
    }
    problems.throw_if_any();
    warn_of_misspelt_columns(table, warnings);
    warn_of_what_was_made(table, warnings);
    return result;
}

ClimateSeries read_climate_of_one_place(const Table& table, config::Warnings& warnings) {
    std::vector<ClimateSeries> all = read_climate(table, warnings);
    if (all.size() != 1) {
        config::fail(ExitCode::data, {table.file()}, std::to_string(all.size()) + " elevations in elev_m",
                     "the months of one place", "leave out the rows of the other elevations");
    }
    return std::move(all.front());
}

double expected_frost_days(double tmin_degc, int month) {
    return days_in_month(month) * normal_probability(-tmin_degc / daily_scatter_k);
}

}  // namespace forest
