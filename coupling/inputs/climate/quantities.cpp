#include "coupling/inputs/climate/quantities.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::climate {
namespace {

using config::joined;

constexpr double kelvin_of_0_degc = 273.15;
constexpr double hottest_degc = 150.0;    ///< and coldest kelvin
constexpr double brightest_mjpm2 = 45.0;  ///< as in forest/climate/climate_checks
constexpr double heaviest_mmps = 0.02;    ///< 1700 mm a day: no sum of a series stays below it
constexpr double joule_per_megajoule = 1e6;
constexpr double hours_of_day = 24.0;

bool is_temperature(const Quantity& quantity) {
    return quantity.unit == "c";
}

/// How services write that a day has no value.
bool is_no_value(double value) {
    constexpr std::array signs{-999.0, -9999.0, -99999.0, -999.9, -99.9};
    return std::find(signs.begin(), signs.end(), value) != signs.end();
}

struct Numbers {
    std::vector<std::optional<double>> of_rows;
    std::vector<double> sorted;  ///< those that are there
};

Numbers numbers_of(const config::Table& table, std::string_view column) {
    Numbers numbers;
    config::Problems problems;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        std::optional<double> value;
        if (!table.text(row, column).empty()) {
            value = table.number(row, column, {}, problems);
        }
        if (value && is_no_value(*value)) {
            value.reset();
        }
        if (value) {
            numbers.sorted.push_back(*value);
        }
        numbers.of_rows.push_back(value);
    }
    problems.throw_if_any();
    std::sort(numbers.sorted.begin(), numbers.sorted.end());
    return numbers;
}

double at_share(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// Whether numbers may be in our unit; what is wrong within it, its checks find.
bool may_be_ours(const Quantity& quantity, const std::vector<double>& sorted, bool are_days) {
    constexpr double upper_quarter = 0.75;
    if (sorted.empty()) {
        return true;
    }
    if (is_temperature(quantity)) {
        return at_share(sorted, 0.5) < hottest_degc;
    }
    if (quantity.column == "sunshine_h") {
        constexpr double longest_month_h = 744.0;
        return sorted.back() <= longest_month_h && (!are_days || sorted.back() <= hours_of_day);
    }
    return quantity.column == "prec_mm" ? sorted.back() >= heaviest_mmps
                                        : at_share(sorted, upper_quarter) <= brightest_mjpm2;
}

/// "(MJ/m^2/day)" at the end of a line that begins with the name of the column.
std::string unit_above_header(const config::Table& table, const std::string& found) {
    for (const std::string& line : table.lines_above()) {
        const bool is_of_column = line.starts_with(found) && line.size() > found.size() &&
                                  std::isspace(static_cast<unsigned char>(line[found.size()])) != 0;
        const std::size_t open = line.rfind('(');
        if (is_of_column && open != std::string::npos) {
            return config::form_of(joined("x ", line.substr(open))).unit;
        }
    }
    return "";
}

std::string unit_of_service(const std::string& found) {
    const config::Table shipped = config::read_shipped_table("climate_units.csv");
    for (std::size_t row = 0; row < shipped.rows(); ++row) {
        if (config::in_lower_case(shipped.text(row, "name")) == config::in_lower_case(found)) {
            return config::form_of(joined("x (", shipped.text(row, "unit"), ")")).unit;
        }
    }
    return "";
}

std::string unit_of(const config::Table& table, const Quantity& quantity, const std::string& found,
                    const std::vector<double>& sorted, bool are_days) {
    const std::string of_service = unit_of_service(found);  // cglo_j is a whole name, not one in joules
    if (std::string unit = config::form_of(found).unit; !unit.empty() && of_service.empty()) {
        return unit;
    }
    if (std::string unit = unit_above_header(table, found); !unit.empty()) {
        return unit;
    }
    if (may_be_ours(quantity, sorted, are_days)) {
        return std::string{quantity.unit};
    }
    return is_temperature(quantity) ? "k" : of_service;
}

/// The column with the seconds between sunrise and sunset, as Daymet has it.
std::optional<std::string> day_length_column(const config::Table& table) {
    for (const std::string& column : table.columns()) {
        const std::string letters = config::form_of(column).letters;
        if (letters == "dayls" || letters == "dayl") {
            return column;
        }
    }
    return std::nullopt;
}

/// Days that a row stands for.
double days_of(const Date& date) {
    if (date.day > 0) {
        return 1.0;
    }
    return days_of_month(date.year, date.month);
}

/// " * 3.6", " / 60".
std::string times_in_words(double factor) {
    const double divisor = factor > 0.0 && factor < 1.0 ? std::round(1.0 / factor) : 1.0;
    constexpr double same = 1e-12;
    return divisor > 1.0 && std::abs(divisor * factor - 1.0) < same ? joined(" / ", config::to_text(divisor))
                                                                    : joined(" * ", config::to_text(factor));
}

/// Makes the numbers ours. False for a unit without a way to ours.
bool convert(const config::Table& table, const Quantity& quantity, const std::string& unit,
             const std::vector<Date>& dates, Values& values) {
    const auto change = [&](const auto& ours_of) {
        for (std::size_t row = 0; row < values.of_rows.size(); ++row) {
            if (auto& value = values.of_rows[row]) {
                value = ours_of(row, *value);
            }
        }
    };
    if (is_temperature(quantity)) {
        values.how_read = joined(config::in_quotes(values.found), " - ", config::to_text(kelvin_of_0_degc));
        change([](std::size_t, double value) { return value - kelvin_of_0_degc; });
        return unit == "k";
    }
    const double per_day = config::unit_factor(unit, "mmpd");
    if (quantity.column == "prec_mm" && per_day > 0.0) {
        values.how_read = joined(config::in_quotes(values.found), " * ",
                                 per_day == 1.0 ? "" : joined(config::to_text(per_day), " * "), "days");
        change([&](std::size_t row, double value) { return value * per_day * days_of(dates[row]); });
        return true;
    }
    if (const auto day_length = day_length_column(table); unit == "wpm2" && day_length) {
        values.how_read = joined(config::in_quotes(values.found), " * ", config::in_quotes(*day_length),
                                 " / ", config::to_text(joule_per_megajoule));
        const Numbers seconds = numbers_of(table, *day_length);
        change([&](std::size_t row, double value) {
            return seconds.of_rows[row] ? std::optional{value * *seconds.of_rows[row] / joule_per_megajoule}
                                        : std::nullopt;
        });
        return true;
    }
    const double factor = config::unit_factor(unit, quantity.unit);
    values.how_read = joined(config::in_quotes(values.found), times_in_words(factor));
    change([&](std::size_t, double value) { return value * factor; });
    return factor > 0.0;
}

}  // namespace

std::optional<Values> values_of(const config::Table& table, const Quantity& quantity,
                                const std::vector<Date>& dates) {
    const auto place = table.find(quantity.column);
    if (!place) {
        return std::nullopt;
    }
    Values values;
    values.found = table.found_columns()[*place];
    Numbers numbers = numbers_of(table, quantity.column);
    values.of_rows = std::move(numbers.of_rows);
    values.missing = table.rows() - numbers.sorted.size();
    const std::string unit = unit_of(table, quantity, values.found, numbers.sorted, is_of_days(dates));
    if (unit.empty() || unit == quantity.unit) {
        return values;
    }
    if (!convert(table, quantity, unit, dates, values)) {
        config::Problems problems;
        problems.add(config::other_unit_problem(table.file(), values.found, std::string{quantity.column}));
        problems.throw_if_any();
    }
    return values;
}

std::optional<double> elevation_above_header(const config::Table& table) {
    for (const std::string& line : table.lines_above()) {
        const std::string low = config::in_lower_case(line);
        const std::size_t word = low.find("elevation");
        const std::size_t mark = word == std::string::npos ? word : low.find_first_of(":=", word);
        if (mark == std::string::npos) {
            continue;
        }
        // NASA POWER: "Elevation from MERRA-2: Average for 0.5 x 0.625 degree lat/lon region = 1432.5 meters"
        const std::size_t equals = low.find('=', word);
        const std::string_view behind =
            config::trimmed(std::string_view{low}.substr((equals == std::string::npos ? mark : equals) + 1));
        const std::size_t end = behind.find_first_not_of("+-.0123456789");
        const auto height_m = config::parse_number(std::string{behind.substr(0, end)});
        const std::string_view unit =
            end == std::string_view::npos ? std::string_view{} : config::trimmed(behind.substr(end));
        if (height_m && unit.starts_with('m')) {
            return height_m;
        }
    }
    return std::nullopt;
}

}  // namespace coupling::climate
