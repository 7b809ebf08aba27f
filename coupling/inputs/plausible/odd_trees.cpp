#include "coupling/inputs/plausible/odd_trees.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::plausible {
namespace {

constexpr double thickest_cm = 200.0;
constexpr double squat_from_cm = 10.0;
constexpr double least_slenderness = 15.0;
constexpr double too_slender = 150.0;
constexpr double impossible_slenderness = 300.0;  // [choice] twice the most slender trees
constexpr double impossible_from_m = 5.0;
constexpr double slender_from_cm = 20.0;
constexpr double most_slenderness = 110.0;
constexpr std::size_t few_trees = 5;
constexpr std::size_t few_for_girths = 10;
constexpr double least_of_half = 32.0;
constexpr double thick_half_cm = 90.0;
constexpr double most_of_mean_pole = 120.0;
constexpr double most_of_mean_tree = 100.0;

std::optional<double> number_in(const config::Table& table, std::size_t row, const char* column) {
    return table.has(column) ? config::parse_number(table.text(row, column)) : std::nullopt;
}

/// The middle one of at least so many values; 0 of fewer.
double median_of_enough(std::vector<double> values) {
    if (values.size() < few_for_girths) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

OddTrees odd_trees(const config::Table& table) {
    OddTrees found;
    std::size_t thick = 0;
    std::size_t slender = 0;
    std::vector<double> slendernesses;
    std::vector<double> diameters_cm;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string state = table.has("state") ? table.text(row, "state") : "";
        const std::optional<double> dbh_cm = number_in(table, row, "dbh_cm");
        if (!dbh_cm || *dbh_cm <= 0.0 || !(state.empty() || state == "living")) {
            continue;
        }
        const double height_m = number_in(table, row, "height_m").value_or(0.0);
        const double slenderness = 100.0 * height_m / *dbh_cm;
        if (*dbh_cm >= squat_from_cm) {
            diameters_cm.push_back(*dbh_cm);
            if (height_m > 0.0) {
                slendernesses.push_back(slenderness);
            }
        }
        if (*dbh_cm > thickest_cm ||
            (height_m > 0.0 && *dbh_cm >= squat_from_cm && slenderness < least_slenderness)) {
            found.lines.push_back(table.place(row, "dbh_cm").line);
        }
        if (*dbh_cm >= squat_from_cm && slenderness > too_slender) {
            found.slender_lines.push_back(table.place(row, "height_m").line);
        }
        if (height_m >= impossible_from_m && slenderness > impossible_slenderness) {
            found.impossible_lines.push_back(table.place(row, "dbh_cm").line);
        }
        if (height_m > 0.0 && *dbh_cm >= slender_from_cm) {
            ++thick;
            slender += slenderness > most_slenderness ? 1 : 0;
        }
    }
    constexpr std::size_t list_of_one = 10;
    const std::size_t impossible = found.impossible_lines.size();
    found.are_impossible =
        impossible >= few_trees || (impossible > 0 && list_of_one * impossible >= table.rows());
    const double half_slenderness = median_of_enough(slendernesses);
    const double half_cm = median_of_enough(diameters_cm);
    found.girth_slenderness =
        half_slenderness > 0.0 && half_slenderness < least_of_half ? half_slenderness : 0.0;
    found.girth_median_cm = slendernesses.empty() && half_cm > thick_half_cm ? half_cm : 0.0;
    found.columns_look_swapped = thick >= few_trees && 2 * slender > thick;
    return found;
}

std::vector<std::size_t> odd_mean_trees(const config::Table& table) {
    std::vector<std::size_t> lines;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double dbh_cm = number_in(table, row, "mean_dbh_cm").value_or(0.0);
        const std::optional<double> height_m = number_in(table, row, "mean_height_m");
        if (!height_m || *height_m <= 0.0 || dbh_cm < squat_from_cm) {
            continue;
        }
        const double slenderness = 100.0 * *height_m / dbh_cm;
        const double most = dbh_cm < slender_from_cm ? most_of_mean_pole : most_of_mean_tree;
        if (slenderness < least_slenderness || slenderness > most) {
            lines.push_back(table.place(row, "mean_dbh_cm").line);
        }
    }
    return lines;
}

void judge_heights_without_dbh(std::vector<double> heights_m, const std::string& file, Reading& reading) {
    constexpr std::size_t fewest = 10;
    constexpr double highest_median_m = 45.0;  // [choice] 148 feet; few stands of Europe are higher
    if (heights_m.size() < fewest) {
        return;
    }
    const auto middle = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2);
    std::nth_element(heights_m.begin(), middle, heights_m.end());
    if (*middle > highest_median_m) {
        reading.warn({file},
                     config::joined("half of the trees without dbh_cm higher than ",
                                    std::to_string(std::lround(*middle)), " m: the heights look like feet"),
                     "heights in metres", "multiply them by 0.3048 if they are feet", config::Effect::answer);
    }
}

}  // namespace coupling::plausible
