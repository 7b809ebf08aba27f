#include "coupling/inputs/climate/quantities.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/column_names.hpp"

namespace coupling::climate {
namespace {

using config::joined;

constexpr double kelvin_of_0_degc = 273.15;
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
    if (quantity.column == "sunshine_h") {
        constexpr double longest_month_h = 744.0;
        return sorted.back() <= longest_month_h && (!are_days || sorted.back() <= hours_of_day);
    }
    return quantity.column == "prec_mm" ? sorted.back() >= heaviest_mmps
                                        : at_share(sorted, upper_quarter) <= brightest_mjpm2;
}

/// How the numbers of a column are written: in a unit, perhaps in parts of it, as "in 0.1 mm".
struct Written {
    std::string unit;
    double size = 1.0;
    bool has_traces = false;  ///< a negative number stands for less than can be measured
};

/// "(MJ/m^2/day)", "(in 0.1 degrees Celsius)".
std::optional<Written> written_in(std::string_view brackets) {
    std::string_view text = config::trimmed(brackets);
    if (text.starts_with("in ")) {
        text = config::trimmed(text.substr(3));
    }
    Written written;
    if (const std::size_t end = text.find(' '); end != std::string_view::npos) {
        if (const auto size = config::parse_number(text.substr(0, end)); size && *size > 0.0) {
            written.size = *size;
            text = config::trimmed(text.substr(end));
        }
    }
    const config::ColumnForm form = config::form_of(joined("x (", text, ")"));
    written.unit = form.unit;
    const bool is_unit_alone = form.quantity == "x";  // not "(-1 for <0.05 mm)"
    return written.unit.empty() || !is_unit_alone ? std::nullopt : std::optional{written};
}

/// The line above the header that begins with the name of a column, and what follows it; empty without one.
std::string_view explanation_of(const config::Table& table, const std::string& found) {
    for (const std::string& line : table.lines_above()) {
        if (line.starts_with(found) && line.size() > found.size() &&
            std::isspace(static_cast<unsigned char>(line[found.size()])) != 0) {
            return std::string_view{line}.substr(found.size());
        }
    }
    return {};
}

/// The last unit in brackets of an explanation.
std::optional<Written> written_above_header(const config::Table& table, const std::string& found) {
    const std::string_view line = explanation_of(table, found);
    for (std::size_t open = line.rfind('('); open != std::string_view::npos;
         open = open == 0 ? std::string_view::npos : line.rfind('(', open - 1)) {
        const std::size_t close = std::min(line.find(')', open), line.size());
        if (auto written = written_in(line.substr(open + 1, close - open - 1))) {
            written->has_traces = line.find("(-1 ") != std::string_view::npos;
            return written;
        }
    }
    return std::nullopt;
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

double mean_of(const std::vector<double>& numbers) {
    return numbers.empty()
               ? 0.0
               : std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

/// Temperatures without a unit that no place of the earth has: whole numbers of NOAA in degrees Fahrenheit,
/// or in tenths of a degree. Hottest on record are means of 41 degC of daily maxima and of 34 degC of all
/// hours (Dallol, Ethiopia); so Fahrenheit is seen from a mean of about 1 degC on.
void refuse_what_is_too_hot(const config::Table& table, const Quantity& quantity, const std::string& found,
                            const std::vector<double>& sorted) {
    const double hottest_mean_degc = quantity.column == "tmax_c" ? 42.0 : 34.0;
    if (sorted.empty() || mean_of(sorted) <= hottest_mean_degc) {
        return;
    }
    constexpr double hottest_degf = 135.0;  // 56.7 degC, Death Valley 1913
    const bool are_tenths = sorted.back() > hottest_degf;
    config::fail(config::ExitCode::data, {table.file()},
                 joined("column ", config::in_quotes(found), " with a mean of ",
                        config::to_text(std::round(mean_of(sorted)))),
                 joined(quantity.column, ", in degrees Celsius, which no place has more than ",
                        config::to_text(hottest_mean_degc), " of on average"),
                 are_tenths ? joined("these look like tenths of a degree: order metric units (NOAA: "
                                     "units=metric), or divide the column by 10 (NOAA: PRCP, too)")
                            : joined("these look like degrees Fahrenheit: order metric units (NOAA: "
                                     "units=metric), or say the units in the header: ",
                                     found, " [degF] (NOAA: PRCP [in], too)"));
}

Written written(const config::Table& table, const Quantity& quantity, const std::string& found,
                const std::vector<double>& sorted, bool are_days) {
    const std::string of_service = unit_of_service(found);  // cglo_j is a whole name, not one in joules
    if (std::string unit = config::form_of(found).unit; !unit.empty() && of_service.empty()) {
        return {std::move(unit)};
    }
    if (auto above = written_above_header(table, found)) {
        return *above;
    }
    if (is_temperature(quantity)) {
        constexpr double coldest_k = 180.0;
        constexpr double hottest_k = 335.0;
        const bool are_kelvin = !sorted.empty() && sorted.front() > coldest_k && sorted.back() < hottest_k;
        if (!are_kelvin) {
            refuse_what_is_too_hot(table, quantity, found, sorted);
        }
        return {are_kelvin ? "k" : "c"};
    }
    return {may_be_ours(quantity, sorted, are_days) ? std::string{quantity.unit} : of_service};
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
        constexpr double freezing_degf = 32.0;
        const bool are_degf = unit == "f";
        const double zero = are_degf ? freezing_degf : unit == "k" ? kelvin_of_0_degc : 0.0;
        values.how_read =
            joined(are_degf ? "(" : "", config::in_quotes(values.found),
                   zero > 0.0 ? joined(" - ", config::to_text(zero)) : "", are_degf ? ") / 1.8" : "");
        change([&](std::size_t, double value) { return (value - zero) / (are_degf ? 1.8 : 1.0); });
        return unit == "k" || unit == "c" || are_degf;
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
    values.how_read = joined(config::in_quotes(values.found), formats::times_in_words(factor));
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
    const Written as = written(table, quantity, values.found, numbers.sorted, is_of_days(dates));
    if (as.has_traces && quantity.of_month == OfMonth::sum) {
        for (auto& value : values.of_rows) {
            value = value ? std::optional{std::max(0.0, *value)} : value;
        }
    }
    const bool is_ours = as.unit.empty() || as.unit == quantity.unit;
    if (is_ours && as.size == 1.0) {
        return values;
    }
    for (auto& value : values.of_rows) {
        value = value ? std::optional{as.size * *value} : value;
    }
    if (!is_ours && !convert(table, quantity, as.unit, dates, values)) {
        config::Problems problems;
        problems.add(config::other_unit_problem(table.file(), values.found, std::string{quantity.column}));
        problems.throw_if_any();
    }
    if (as.size != 1.0) {
        values.how_read = joined(values.how_read.empty() ? config::in_quotes(values.found) : values.how_read,
                                 formats::times_in_words(as.size));
    }
    return values;
}

bool is_explained_as(const config::Table& table, const std::string& found, std::string_view words) {
    return config::in_lower_case(explanation_of(table, found)).find(words) != std::string::npos;
}

namespace {

/// Of a place in a table of its own above the days: latitude,longitude,elevation and their numbers.
std::optional<double> elevation_in_block(const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        std::string_view names = lines[i];
        std::string_view numbers = lines[i + 1];
        while (!names.empty() && !numbers.empty()) {
            const std::size_t name_end = std::min(names.find(','), names.size());
            const std::size_t number_end = std::min(numbers.find(','), numbers.size());
            if (config::in_lower_case(names.substr(0, name_end)) == "elevation") {
                return config::parse_number(numbers.substr(0, number_end));
            }
            names.remove_prefix(std::min(name_end + 1, names.size()));
            numbers.remove_prefix(std::min(number_end + 1, numbers.size()));
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> elevation_above_header(const config::Table& table) {
    if (const auto elevation_m = elevation_in_block(table.lines_above())) {
        return elevation_m;
    }
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
