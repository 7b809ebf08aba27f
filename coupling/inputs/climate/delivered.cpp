#include "coupling/inputs/climate/delivered.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/climate/dates.hpp"
#include "coupling/inputs/climate/months.hpp"
#include "coupling/inputs/climate/quantities.hpp"
#include "coupling/inputs/formats/column_names.hpp"

namespace coupling::climate {
namespace {

using config::joined;

/// Months side by side, as NASA POWER has them: its T2M_MAX of a month is that of the hottest hour, not a
/// mean of daily maxima, so that turning the table would not do.
void refuse_months_in_columns(const config::Table& table) {
    if (table.find("jan") && table.find("jul") && table.find("dec")) {
        config::fail(
            config::ExitCode::data, {table.file()}, "months in columns (JAN to DEC)",
            "a row for each day or month",
            "ask the service for daily values (NASA POWER: Daily, CSV), or turn the table so that each "
            "month is a row with year, month, tmin_c, tmax_c, prec_mm, rad_mj_m2_d");
    }
}

/// Names that mean one thing here and another there, such as RH: rain of the Dutch service, and humidity of
/// others. The explanation above the header decides.
void take_explained_names(config::Table& table) {
    constexpr std::array<std::pair<const char*, std::string_view>, 3> explained{
        {{"prec_mm", "daily precipitation amount"},
         {"rad_mj_m2_d", "global radiation (in"},
         {"tave_c", "daily mean temperature"}}};
    for (const auto& [column, words] : explained) {
        for (std::size_t i = 0; i < table.columns().size() && !table.find(column); ++i) {
            if (is_explained_as(table, table.found_columns()[i], words)) {
                table.rename(std::string{table.columns()[i]}, column);
            }
        }
    }
}

/// Days or months, each once.
void refuse_repeated_dates(const config::Table& table, const std::vector<Date>& dates, const char* column) {
    std::map<Date, std::size_t> rows;
    for (std::size_t row = 0; row < dates.size(); ++row) {
        const auto [first, is_new] = rows.emplace(dates[row], row);
        if (!is_new) {
            config::fail(
                config::ExitCode::data, table.place(row, column),
                joined("the same date as line ", std::to_string(table.place(first->second, column).line)),
                "one row for each day or month, of one place",
                "leave out the rows of other stations; make days of hours first");
        }
    }
}

/// The column that dates come from.
const char* column_of_dates(const config::Table& table) {
    return table.find("day") ? "day" : table.find("day_of_year") ? "day_of_year" : "date";
}

struct Found {
    Quantity quantity;
    Values values;
};

std::string conversions_of(const std::vector<Found>& found) {
    std::string text;
    for (const auto& [quantity, values] : found) {
        if (!values.how_read.empty()) {
            text += joined(text.empty() ? "" : ", ", quantity.column, " = ", values.how_read);
        }
    }
    return text;
}

std::vector<Found> all_values(const config::Table& table, const std::vector<Date>& dates) {
    std::vector<Found> found;
    for (const Quantity& quantity : quantities) {
        if (quantity.column == "sunshine_h" && table.find("rad_mj_m2_d")) {
            continue;  // nobody needs it then, and its gaps are none
        }
        if (auto values = values_of(table, quantity, dates)) {
            found.push_back({quantity, std::move(*values)});
        }
    }
    return found;
}

/// Writes numbers and months into a table of months, which keeps its other columns.
void put_into(config::Table& table, const std::vector<Date>& dates, const std::vector<Found>& found) {
    std::vector<std::string> years;
    std::vector<std::string> months;
    for (std::size_t row = 0; row < dates.size(); ++row) {
        years.push_back(std::to_string(dates[row].year));
        months.push_back(std::to_string(dates[row].month));
        for (const auto& [quantity, values] : found) {
            if (!values.how_read.empty()) {
                const auto& value = values.of_rows[row];
                table.set_text(row, quantity.column, value ? config::to_text(in_places(*value)) : "");
            }
        }
    }
    if (!table.find("month")) {
        table.add_column("month", std::move(months), "date");
    }
    if (!table.find("year")) {
        table.add_column("year", std::move(years), "date");
    }
}

/// The dates of a table of months with columns year and month; what is no month, its reader refuses.
std::vector<Date> dates_of_months(const config::Table& table) {
    std::vector<Date> dates;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const long long year = config::parse_whole(table.text(row, "year")).value_or(0);
        const long long month = config::parse_whole(table.text(row, "month")).value_or(1);
        dates.push_back({static_cast<int>(year), month >= 1 && month <= 12 ? static_cast<int>(month) : 1, 0});
    }
    return dates;
}

/// The height of the place, from its column or from the lines above the header.
std::optional<double> elevation_of(const config::Table& table, Delivered& delivered) {
    if (table.find("elev_m") && !table.text(0, "elev_m").empty()) {
        config::Problems problems;
        const auto elevation_m = table.number(0, "elev_m", {}, problems);
        problems.throw_if_any();
        return elevation_m;
    }
    const auto elevation_m = elevation_above_header(table);
    if (elevation_m) {
        delivered.notes.push_back(joined(table.file(), ": elev_m ", config::to_text(*elevation_m),
                                         ", from the lines above the header"));
    }
    return elevation_m;
}

void note_names(const config::Table& table, const std::vector<Found>& found, Delivered& delivered) {
    std::string names;
    for (const auto& [quantity, values] : found) {
        if (values.found != quantity.column) {
            names +=
                joined(names.empty() ? "" : ", ", config::in_quotes(values.found), " = ", quantity.column);
        }
    }
    if (!names.empty()) {
        delivered.notes.push_back(
            joined(table.file(), ": columns that are read under another name: ", names));
    }
}

/// The monthly table.
config::Features features_of(const config::Table& table, const WholeYears& years,
                             const std::vector<Found>& found, std::optional<double> elevation_m) {
    config::Features features{table.file(), {"year", "month"}, {}, {}};
    for (const auto& [quantity, values] : found) {
        features.columns.emplace_back(quantity.column);
    }
    const bool has_temperatures = table.find("tmin_c") && table.find("tmax_c");
    if (has_temperatures) {
        features.columns.insert(features.columns.end(), {"frost_days", "gdd55_c_d", "abs_tmin_c"});
    }
    if (elevation_m) {
        features.columns.emplace_back("elev_m");
    }
    for (const Month& month : years.months) {
        std::vector<std::string> cells{std::to_string(month.year), std::to_string(month.month)};
        for (const double value : month.values) {
            cells.push_back(config::to_text(in_places(value)));
        }
        if (has_temperatures) {
            for (const double value : {month.frost_days, month.degree_days, month.lowest_degc}) {
                cells.push_back(config::to_text(in_places(value)));
            }
        }
        if (elevation_m) {
            cells.push_back(config::to_text(*elevation_m));
        }
        features.cells.push_back(std::move(cells));
        features.numbers.push_back(
            static_cast<std::uint32_t>(table.place(month.first_row, column_of_dates(table)).line));
    }
    return features;
}

/// What no month can do without, asked for while the columns are still those of the file.
void require_quantities(const config::Table& table) {
    config::Problems missing;
    for (const char* column : {"tmin_c", "tmax_c", "prec_mm"}) {
        const std::vector<std::string> meant = formats::columns_by_part(table, "climate", column);
        if (!table.find(column) && !meant.empty()) {
            missing.add(config::ExitCode::data, {table.file()},
                        joined("no column ", config::in_quotes(column), " (is ",
                               config::in_quotes(meant.front()), " meant to be it?)"),
                        "", joined("rename it to ", column));
        } else if (!table.find(column)) {
            table.require({column}, missing);
        }
    }
    missing.throw_if_any();
}

/// Of a table of days.
void make_months(config::Table& table, const std::vector<Date>& dates, const std::vector<Found>& found,
                 Delivered& delivered) {
    DaysByMonth days{dates};
    for (const auto& [quantity, values] : found) {
        days.add(quantity, values);
    }
    WholeYears years = days.whole_years();
    if (years.months.empty()) {
        config::fail(
            config::ExitCode::data, {table.file()}, joined("no whole year; gap: ", years.gap),
            "days of at least one year, of which a month lacks five values at most and three in a row");
    }
    delivered.notes.push_back(joined(table.file(), ": months made of ", std::to_string(dates.size()),
                                     " days, ", std::to_string(years.months.front().year), " to ",
                                     std::to_string(years.months.back().year)));
    if (years.filled > 0) {
        delivered.notes.push_back(joined(
            table.file(), ": single days without a value, passed over: ", std::to_string(years.filled)));
    }
    if (!years.left_out.empty()) {
        const std::string gaps = joined("years left out: ", years.left_out, "; gap: ", years.gap);
        if (years.is_cut_inside) {
            delivered.warnings.push_back({config::ExitCode::data,
                                          {table.file()},
                                          gaps,
                                          "years without a gap: the longest run of them is taken"});
        } else {
            delivered.notes.push_back(joined(table.file(), ": ", gaps));
        }
    }
    note_names(table, found, delivered);
    config::Features features = features_of(table, years, found, elevation_of(table, delivered));
    table = config::Table::of(std::move(features));
    table.watch();
}

}  // namespace

Delivered take_delivered(config::Table& table) {
    refuse_months_in_columns(table);
    take_explained_names(table);
    Delivered delivered;
    if (table.rows() == 0) {
        return delivered;
    }
    const std::optional<std::vector<Date>> given = dates_of(table);
    if (!given && (!table.find("year") || !table.find("month"))) {
        return delivered;  // what is missing, the reader of months says
    }
    if (given) {
        refuse_repeated_dates(table, *given, column_of_dates(table));
    }
    const std::vector<Date> dates = given ? *given : dates_of_months(table);
    const std::vector<Found> found = all_values(table, dates);
    if (const std::string conversions = conversions_of(found); !conversions.empty()) {
        delivered.notes.push_back(joined(table.file(), ": numbers in other units: ", conversions));
    }
    if (given && is_of_days(*given)) {
        require_quantities(table);
        make_months(table, dates, found, delivered);
    } else {
        put_into(table, dates, found);
    }
    return delivered;
}

}  // namespace coupling::climate
