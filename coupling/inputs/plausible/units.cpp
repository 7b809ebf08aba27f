#include "coupling/inputs/plausible/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

constexpr double thickest_median_cm = 200.0;
constexpr double thickest_log_median_cm = 100.0;
constexpr double thinnest_median_cm = 1.5;
constexpr double highest_median_m = 75.0;
constexpr double breast_height_m = 1.3;
/// Trees from here on are no saplings, whose slenderness says nothing.
constexpr double tree_from_cm = 5.0;
/// Half of the trees are never so slender: dense thickets reach 120 [choice].
constexpr double most_slender_median = 140.0;
/// Of exchanged columns half of the trees are more slender than this: trees 70 to 90 times as high as thick
/// become 110 to 140 times [choice].
constexpr double swapped_median = 105.0;
constexpr std::size_t fewest_measured = 10;
/// Half of the trees of a stand are seldom higher; 45 m are 148 feet [choice].
constexpr double high_median_m = 45.0;

/// The value that a share of all lies below; 0 without any.
double share_below(std::vector<double> values, double share) {
    if (values.empty()) {
        return 0.0;
    }
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

double median_of(const std::vector<double>& values) {
    return share_below(values, 0.5);
}

bool is_living(const config::Table& table, std::size_t row) {
    return !table.has("state") || table.text(row, "state").empty() || table.text(row, "state") == "living";
}

/// A positive number; 0 for anything else.
double number_or_0(const config::Table& table, std::size_t row, const std::string& column) {
    const auto value = table.has(column) ? config::parse_number(table.text(row, column)) : std::nullopt;
    return value ? std::max(0.0, *value) : 0.0;
}

[[noreturn]] void refuse_unit(const config::Table& table, const std::string& column, double median,
                              const std::string& unit, const std::string& looks_like,
                              const std::string& advice) {
    config::fail(config::ExitCode::data, {table.file()},
                 joined("a median ", column, " of ", config::to_text(std::round(1e4 * median) / 1e4),
                        ", which looks like ", looks_like),
                 unit, advice);
}

/// Standard deviation over mean; 0 without values.
double variation_of(const std::vector<double>& values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    const double squares = std::accumulate(values.begin(), values.end(), 0.0, [&](double sum, double value) {
        return sum + (value - mean) * (value - mean);
    });
    return mean > 0.0 ? std::sqrt(squares / count) / mean : 0.0;
}

std::string times(const std::string& factor, const std::string& column) {
    return joined("multiply the column ", column, " by ", factor);
}

/// Trees with both figures, saplings left out.
struct Measured {
    std::vector<double> dbh_cm;
    std::vector<double> height_m;
    std::vector<double> slenderness;
};

/// Refuses lists of which most trees are too slender to stand: exchanged columns, feet, inches. Diameters
/// vary more than heights in every stand, as heights level off; in exchanged columns it is the other way
/// round.
void refuse_too_slender(const config::Table& table, const Measured& trees) {
    const double ratio = median_of(trees.slenderness);
    if (trees.slenderness.size() < fewest_measured || ratio <= swapped_median) {
        return;
    }
    const std::string found =
        joined("half of the trees more than ", config::to_text(std::floor(ratio)), " times as high as thick");
    const std::string expected = "stands 60 to 130 times as high as thick";
    if (variation_of(trees.height_m) > variation_of(trees.dbh_cm)) {
        config::fail(config::ExitCode::data, {table.file()},
                     joined(found,
                            ", and heights that vary more than diameters: the columns dbh_cm and height_m "
                            "look swapped"),
                     expected, "exchange the names of the two columns");
    }
    if (ratio <= most_slender_median) {
        return;
    }
    const bool is_high = median_of(trees.height_m) > high_median_m;
    config::fail(config::ExitCode::data, {table.file()},
                 joined(found, is_high ? ": height_m looks like feet" : ": dbh_cm looks like inches"),
                 expected, is_high ? times("0.3048", "height_m") : times("2.54", "dbh_cm"));
}

}  // namespace

void refuse_girths_alone(const config::Table& table) {
    constexpr std::array<std::string_view, 6> words{"girth", "circumf", "umfang", "circonf", "c130", "gbh"};
    if (table.has("dbh_cm")) {
        return;
    }
    for (const std::string& column : table.columns()) {
        const std::string lower = config::in_lower_case(column);
        if (std::any_of(words.begin(), words.end(),
                        [&](std::string_view word) { return lower.find(word) != std::string::npos; })) {
            config::fail(
                config::ExitCode::data, {table.file()},
                joined("no column 'dbh_cm', but girths in the column ", config::in_quotes(column)),
                "diameters at breast height",
                joined("add a column dbh_cm: ", config::in_quotes(column), " in cm divided by 3.14159"));
        }
    }
}

void check_tree_units(const config::Table& table) {
    std::vector<double> diameters_cm;
    std::vector<double> heights_m;
    std::vector<double> slenderness;
    Measured measured;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (!is_living(table, row)) {
            continue;
        }
        const double dbh_cm = number_or_0(table, row, "dbh_cm");
        const double height_m = number_or_0(table, row, "height_m");
        if (dbh_cm > 0.0) {
            diameters_cm.push_back(dbh_cm);
        }
        if (height_m > 0.0) {
            heights_m.push_back(height_m);
        }
        if (dbh_cm > 0.0 && height_m > 0.0) {
            slenderness.push_back(100.0 * height_m / dbh_cm);
        }
        if (dbh_cm >= tree_from_cm && height_m > 0.0) {
            measured.dbh_cm.push_back(dbh_cm);
            measured.height_m.push_back(height_m);
            measured.slenderness.push_back(slenderness.back());
        }
    }
    const double dbh_cm = median_of(diameters_cm);
    const double height_m = median_of(heights_m);
    const double ratio = median_of(slenderness);
    const double thick_cm = share_below(diameters_cm, 0.95);
    const bool many_thick = thick_cm > 150.0 && ratio < 15.0;
    if (many_thick && dbh_cm <= thickest_median_cm && ratio == 0.0 && thick_cm < 150.0 * M_PI) {
        refuse_unit(table, "dbh_cm", dbh_cm, "diameters in centimetres", "girths or millimetres",
                    "divide the column dbh_cm by 3.14159 if it holds girths, by 10 if millimetres");
    }
    if (dbh_cm > thickest_median_cm || many_thick) {
        refuse_unit(table, "dbh_cm", dbh_cm, "centimetres", "millimetres", times("0.1", "dbh_cm"));
    }
    if (height_m > highest_median_m) {
        refuse_unit(table, "height_m", height_m, "metres", "decimetres or centimetres",
                    "write the heights in metres");
    }
    const bool tall = height_m > 5.0;
    if (dbh_cm > 0.0 && dbh_cm < thinnest_median_cm && (tall || height_m == 0.0)) {
        refuse_unit(table, "dbh_cm", dbh_cm, "centimetres", "metres",
                    joined(times("100", "dbh_cm"), tall ? "" : "; if these are saplings, add height_m"));
    }
    if (tall && ratio > 300.0) {
        refuse_unit(table, "height_m", height_m,
                    joined("trees not ", config::to_text(std::round(ratio)), " times as high as thick"),
                    "decimetres, or dbh_cm another unit",
                    "write heights in metres and dbh_cm in centimetres");
    }
    if (height_m > 0.0 && height_m < breast_height_m && dbh_cm >= 5.0) {
        refuse_unit(table, "height_m", height_m, "metres", "another unit",
                    "write the heights in metres, or leave out the column");
    }
    refuse_too_slender(table, measured);
}

void check_log_units(const config::Table& table) {
    for (const char* column : {"dbh_cm", "diameter1_cm", "diameter2_cm"}) {
        std::vector<double> diameters_cm;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (const double diameter_cm = number_or_0(table, row, column); diameter_cm > 0.0) {
                diameters_cm.push_back(diameter_cm);
            }
        }
        const double median_cm = median_of(diameters_cm);
        if (median_cm > thickest_log_median_cm) {
            refuse_unit(table, column, median_cm, "centimetres", "millimetres", times("0.1", column));
        }
        if (median_cm > 0.0 && median_cm < thinnest_median_cm) {
            refuse_unit(table, column, median_cm, "centimetres", "metres", times("100", column));
        }
    }
}

}  // namespace coupling::plausible
