#include "forest/climate/climate_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "forest/climate/vapour.hpp"

namespace forest {

namespace {

using config::ExitCode;
using config::Problems;
using config::Table;

/// The numbers of a column, those that are none left out.
std::vector<double> numbers_of(const Table& table, std::string_view column) {
    std::vector<double> numbers;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (const auto number = config::parse_number(table.text(row, column))) {
            numbers.push_back(*number);
        }
    }
    return numbers;
}

/// The value that a share of the numbers lies below.
double quantile(std::vector<double> numbers, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(numbers.size() - 1));
    std::nth_element(numbers.begin(), numbers.begin() + at, numbers.end());
    return numbers[static_cast<std::size_t>(at)];
}

std::string rounded(double value) {
    if (value != 0.0 && std::abs(value) < 0.1) {
        std::ostringstream two_figures;
        two_figures << std::setprecision(2) << value;
        return two_figures.str();
    }
    const auto tenths = static_cast<long long>(value * 10.0 + (value < 0.0 ? -0.5 : 0.5));
    return config::to_text(static_cast<double>(tenths) / 10.0);
}

/// Daytime deficit over saturation pressure at the maximum temperature, month by month [-].
std::vector<double> dryness_of(const Table& table, std::string_view deficit_column) {
    std::vector<double> dryness;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto deficit = config::parse_number(table.text(row, deficit_column));
        const auto tmax = config::parse_number(table.text(row, "tmax_c"));
        if (deficit && tmax && *tmax > -80.0 && *tmax < 60.0) {
            dryness.push_back(*deficit / saturation_pressure_kpa(*tmax));
        }
    }
    return dryness;
}

/// Months of one kind that a warning counts.
struct Suspicion {
    std::size_t months = 0;
    std::size_t first_line = 0;

    void add(const Table& table, std::size_t row) {
        const std::size_t line = table.place(row, "month").line;
        first_line = months == 0 ? line : std::min(first_line, line);
        ++months;
    }

    void warn(const Table& table, const std::string& what, config::Warnings& warnings) const {
        if (months > 0) {
            warnings.add(table.file() + ": " + std::to_string(months) + (months == 1 ? " month" : " months") +
                         " with " + what + ", the first in line " + std::to_string(first_line));
        }
    }
};

void expect(bool holds, const Table& table, std::size_t row, std::string_view column,
            const std::string& expected, Problems& problems) {
    if (!holds && table.has(column)) {
        problems.add(ExitCode::data, table.place(row, column),
                     std::string{column} + " " + config::in_quotes(table.text(row, column)), expected);
    }
}

/// A sum or mean over the year, the unit that the table has to be in, and other units that people have.
struct YearlyFigure {
    struct Unit {
        double factor;
        const char* words;
    };
    std::string_view column;
    const char* what;
    double value;
    double least_possible;  ///< below it no place between 30 and 70 degrees lies: another unit
    double least_usual, most_usual;
    const char* wanted;
    const char* hint;
    std::vector<Unit> units;  ///< the likelier first
};

/// The unit in which a figure would be a usual one; empty without such a unit.
std::string fitting_unit(const YearlyFigure& figure) {
    for (const YearlyFigure::Unit& unit : figure.units) {
        const double converted = figure.value * unit.factor;
        if (converted >= figure.least_usual && converted <= figure.most_usual) {
            return unit.words;
        }
    }
    return {};
}

/// What a year's sums and means say about units and gaps.
void check_the_mean_year(const ClimateSeries& series, const Table& table, Problems& problems,
                         config::Warnings& warnings) {
    double prec_mm = 0.0;
    double tave_degc = 0.0;
    double radiation_mjpm2 = 0.0;
    const auto months = 12.0 * static_cast<double>(series.years.size());
    for (const ClimateYear& year : series.years) {
        for (const ClimateMonth& month : year.months) {
            prec_mm += 12.0 * month.prec_mm / months;
            tave_degc += month.tave_degc / months;
            radiation_mjpm2 += month.radiation_mjpm2 / months;
        }
    }
    constexpr double days = 30.44;  // of a mean month
    // Lowest sums and means of inhabited places between 30 and 70 degrees: forests end above 200 mm, steppes
    // at 100; the darkest coasts at 70 degrees north have 6.5 MJ/m2 a day [choice].
    const std::array<YearlyFigure, 3> figures{
        {{"prec_mm",
          "precipitation (mm)",
          prec_mm,
          100.0,
          250.0,
          4000.0,
          "mm a month",
          "is it mm a month?",
          {{days, "mm a day (times the days of the month)"},
           {days * 86400.0, "kg m-2 s-1 (times 86400 and the days of the month)"},
           {1000.0, "m a month (times 1000)"},
           {10.0, "cm a month (times 10)"},
           {25.4, "inches a month (times 25.4)"}}},
         {"tave_c",
          "temperature (degC)",
          tave_degc,
          -1e9,
          -8.0,
          20.0,
          "degC",
          "no forest, or another unit?",
          {}},
         {"rad_mj_m2_d",
          "radiation (MJ/m2 a day)",
          radiation_mjpm2,
          6.0,
          6.0,
          25.0,
          "MJ/m2 a day",
          "is it a daily mean on flat ground?",
          {{3.6, "kWh/m2 a day (times 3.6)"}}}}};
    for (const YearlyFigure& figure : figures) {
        const std::string found = std::string{figure.what} + " of a mean year is " + rounded(figure.value);
        if (figure.value < figure.least_possible) {
            const std::string unit = fitting_unit(figure);
            problems.add(ExitCode::data, {table.file()}, std::string{figure.column} + ": " + found,
                         std::string{figure.wanted} + (unit.empty() ? "" : "; this looks like " + unit));
        } else if (figure.value < figure.least_usual || figure.value > figure.most_usual) {
            warnings.add(table.file() + ": " + found + "; " + figure.hint);
        }
    }
}

}  // namespace

void check_units_of_climate(const Table& table, std::string_view radiation_column,
                            std::string_view deficit_column) {
    Problems problems;
    const auto complain = [&](std::string_view column, const std::string& found,
                              const std::string& expected) {
        problems.add(ExitCode::data, {table.file()}, std::string{column} + " " + found, expected);
    };
    // A month of full sun has 30 MJ/m2 a day; in W/m2 the upper quarter of all months lies beyond 100.
    if (const auto radiation = numbers_of(table, radiation_column);
        !radiation.empty() && quantile(radiation, 0.75) > 45.0) {
        // No month has a mean above 400 W/m2 day and night; sums of summer months reach 600 MJ/m2.
        const bool is_sum = quantile(radiation, 0.9) > 400.0;
        complain(radiation_column, "of " + rounded(quantile(radiation, 0.5)) + " in the middle month",
                 is_sum ? "MJ/m2 a day; this looks like MJ/m2 a month (divide by its days)"
                        : "MJ/m2 a day; this looks like W/m2 (times 0.0864; means of daylight alone, as "
                          "Daymet has them, times the day length in s / 1000000)");
    }
    if (!deficit_column.empty()) {
        if (const auto dryness = dryness_of(table, deficit_column);
            !dryness.empty() && quantile(dryness, 0.5) > 1.0) {
            complain(deficit_column, "above saturation in most months",
                     "kPa; this looks like hPa (times 0.1)");
        }
    }
    for (const std::string_view column : {"tmin_c", "tmax_c", "tave_c"}) {
        if (!table.has(column)) {
            continue;
        }
        if (const auto degrees = numbers_of(table, column);
            !degrees.empty() && quantile(degrees, 0.5) > 150.0) {
            complain(column, "of " + rounded(quantile(degrees, 0.5)) + " in the middle month",
                     "degC; this looks like kelvin (minus 273.15)");
        }
    }
    problems.throw_if_any();
}

void check_months(const ClimateSeries& series, const Table& table, const RowsOfMonths& rows,
                  Problems& problems, config::Warnings& warnings) {
    Suspicion mean_outside;
    Suspicion warm_frost;
    Suspicion dry;
    // Where a number was refused the others of its row have nothing to agree with.
    std::set<std::size_t> refused_lines;
    for (const config::Problem& problem : problems.list()) {
        refused_lines.insert(problem.place.line);
    }
    for (const auto& [when, row] : rows) {
        const ClimateYear* year = series.find(when.first);
        if (year == nullptr || refused_lines.contains(table.place(row, "month").line)) {
            continue;
        }
        const ClimateMonth& month = year->months[static_cast<std::size_t>(when.second - 1)];
        expect(month.tmin_degc <= month.tmax_degc, table, row, "tmax_c",
               "at least tmin_c, " + config::to_text(month.tmin_degc), problems);
        expect(!month.abs_tmin_degc || *month.abs_tmin_degc <= month.tmin_degc + 0.05, table, row,
               "abs_tmin_c", "at most tmin_c, " + config::to_text(month.tmin_degc), problems);
        const double saturation_kpa = saturation_pressure_kpa(month.tmax_degc);
        expect(month.vpd_kpa <= 1.2 * saturation_kpa, table, row,
               table.has("vpd_kpa") ? "vpd_kpa" : "vpd_day_kpa",
               "at most the saturation pressure at tmax_c, " + rounded(saturation_kpa) + " kPa", problems);
        if (month.tave_degc < month.tmin_degc || month.tave_degc > month.tmax_degc) {
            mean_outside.add(table, row);
        }
        if ((month.tmin_degc > 9.0 && month.frost_days > 5.0) ||
            (month.tmin_degc < -9.0 && month.frost_days < 20.0)) {
            warm_frost.add(table, row);
        }
        if (month.vpd_kpa > 0.85 * saturation_kpa) {
            dry.add(table, row);
        }
    }
    mean_outside.warn(table, "tave_c outside tmin_c and tmax_c", warnings);
    warm_frost.warn(table, "frost_days that contradict tmin_c", warnings);
    dry.warn(table, "a deficit near saturation, as in no forest", warnings);
    if (problems.empty()) {
        check_the_mean_year(series, table, problems, warnings);
    }
}

}  // namespace forest
