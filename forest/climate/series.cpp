#include "forest/climate/series.hpp"

#include <algorithm>
#include <map>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "forest/climate/calendar.hpp"
#include "forest/climate/climate_checks.hpp"
#include "forest/climate/normal.hpp"
#include "forest/climate/vapour.hpp"

namespace forest {

struct ClimateRow : ClimateMonth {
    int year = 0;
    int month = 0;
    std::optional<double> mean_degc, deficit_kpa, days_of_frost, elevation_m;
};

namespace {

using config::ExitCode;
using config::NumberRange;
using config::Problems;
using config::Table;

/// The name under which a table gives the daytime deficit; "" if it does not.
std::string_view deficit_column(const Table& table) {
    return table.has("vpd_kpa") ? "vpd_kpa" : table.has("vpd_day_kpa") ? "vpd_day_kpa" : "";
}

/// With what the table leaves out.
ClimateMonth whole_month(const ClimateRow& row) {
    ClimateMonth month = static_cast<const ClimateMonth&>(row);
    month.tave_degc = row.mean_degc.value_or(0.5 * (row.tmin_degc + row.tmax_degc));
    month.vpd_kpa = row.deficit_kpa.value_or(vpd_from_temperatures_kpa(row.tmin_degc, row.tmax_degc));
    month.frost_days = row.days_of_frost.value_or(expected_frost_days(row.tmin_degc, row.month));
    return month;
}

/// What a field has to keep to beside its column.
void check_row(const config::Read<ClimateRow>& row, bool has_elevations, config::RowProblems& wrong) {
    const NumberRange days{0.0, row.month == 2 ? 29.0 : days_in_month(row.month) * 1.0};
    if (row.days_of_frost && !days.contains(*row.days_of_frost)) {
        wrong.refuse(row.row, "frost_days",
                     config::joined("frost_days '", config::to_text(*row.days_of_frost), "'"),
                     config::describe("a number", days));
    }
    if (has_elevations && !row.elevation_m) {
        wrong.refuse(row.row, "elev_m", "no elev_m",
                     "the height of the place in each row, or no such column");
    }
}

/// A place and its months while they are collected.
struct ClimatePlace {
    std::map<int, ClimateYear> years;
    std::map<std::pair<int, int>, std::size_t> rows;  ///< by year and month
};

void check_complete(const ClimatePlace& place, const Table& table, const std::string& where,
                    Problems& problems) {
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
std::map<double, ClimatePlace> read_places(const Table& table, config::RowProblems& wrong) {
    const bool by_day = deficit_column(table) == "vpd_day_kpa";
    std::map<double, ClimatePlace> places;
    for (const auto& row : climate_columns(by_day).all(table)) {
        check_row(row, table.has("elev_m"), wrong);
        ClimatePlace& place = places[row.elevation_m.value_or(0.0)];
        const auto [before, fresh] = place.rows.emplace(std::pair{row.year, row.month}, row.row);
        if (!fresh) {
            wrong.refuse(row.row, "month",
                         config::joined("month ", std::to_string(row.month), " of ", std::to_string(row.year),
                                        " a second time"),
                         config::joined("each month once (first in line ",
                                        std::to_string(table.place(before->second, "month").line), ")"));
            continue;
        }
        ClimateYear& in = place.years[row.year];
        in.year = row.year;
        in.months[static_cast<std::size_t>(row.month - 1)] = whole_month(row);
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
    std::vector<std::string> read = climate_columns(false).names();
    read.emplace_back("vpd_day_kpa");
    std::vector<std::string> absent;
    for (const std::string& name : read) {
        const bool is_other_deficit = name.starts_with("vpd") && !deficit_column(table).empty();
        if (!table.has(name) && !is_other_deficit) {
            absent.push_back(name);
        }
    }
    for (const std::string& column : table.columns_beside(read)) {
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

const config::Schema<ClimateRow>& climate_columns(bool by_day) {
    using R = ClimateRow;
    constexpr NumberRange temperatures{-80.0, 60.0};
    // What no place on earth goes beyond; units other than ours are caught before.
    // clang-format off
    const auto columns_with = [&](const char* deficit) {
        return config::Schema<R>{
            {.role = "climate", .setting = "climate.file", .row = "month", .no_rows = "at least twelve"},
            {{"year", &R::year, "of the calendar", {.range = {0.0, 9999.0}}},
             {"month", &R::month, "1 January to 12", {.range = {1.0, 12.0}}},
             {"tmin_c", &R::tmin_degc, "mean of the daily minima", {.unit = "degC", .range = temperatures}},
             {"tmax_c", &R::tmax_degc, "mean of the daily maxima", {.unit = "degC", .range = temperatures}},
             {"tave_c", &R::mean_degc, "mean; empty: the middle of minimum and maximum", {.unit = "degC", .range = temperatures}},
             {"prec_mm", &R::prec_mm, "rain and snow, sum", {.unit = "mm", .range = {0.0, 3000.0}}},
             {"rad_mj_m2_d", &R::radiation_mjpm2, "global radiation of a mean day on flat ground", {.unit = "MJ/m2/d", .range = {0.0, 45.0}}},
             {deficit, &R::deficit_kpa, "vapour pressure deficit, mean of daytime (or vpd_day_kpa); empty: from temperatures", {.unit = "kPa", .range = {0.0, 12.0}}},
             {"frost_days", &R::days_of_frost, "with a minimum below 0 degC; empty: from tmin_c", {.unit = "days", .range = {0.0, 31.0}}},
             {"gdd55_c_d", &R::degree_days, "sum above 5.5 degC", {.unit = "degC d", .range = {0.0, 1500.0}}},
             {"abs_tmin_c", &R::abs_tmin_degc, "lowest minimum", {.unit = "degC", .range = temperatures}},
             {"elev_m", &R::elevation_m, "height of the place; without the column climate.elevation_m", {.unit = "m", .range = {-500.0, 9000.0}}}}};
    };
    // clang-format on
    static const config::Schema<R> columns = columns_with("vpd_kpa");
    static const config::Schema<R> columns_by_day = columns_with("vpd_day_kpa");
    return by_day ? columns_by_day : columns;
}

std::vector<ClimateSeries> read_climate(const Table& table, config::Warnings& warnings) {
    climate_columns(false).require(table);
    if (table.rows() > 0) {
        check_units_of_climate(table, "rad_mj_m2_d", deficit_column(table));
    }
    config::RowProblems problems{table};
    const std::map<double, ClimatePlace> places = read_places(table, problems);
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
