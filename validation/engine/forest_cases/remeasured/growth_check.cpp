#include "validation/engine/forest_cases/remeasured/growth_check.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::validation::forest_cases::remeasured {
namespace {

using config::ExitCode;
using config::joined;
using config::Problems;
using config::Table;

/// A tape reads a stem to about this much, bark that falls off included; more is worth a look [choice].
constexpr double measuring_error_cm = 0.5;
/// Single trees seldom grow faster than this in diameter; the mean of a plot never does [choice].
constexpr double most_growth_cm_pyear = 3.0;
/// The same of trees that were below the least diameter: they stand in the shade of the others [choice].
constexpr double most_growth_of_new_trees_cm_pyear = 1.0;

/// "lines 4, 7 and 3 more".
std::string lines_in_words(const std::vector<std::size_t>& lines) {
    constexpr std::size_t most_named = 5;
    std::string words = lines.size() == 1 ? "line" : "lines";
    for (std::size_t i = 0; i < std::min(lines.size(), most_named); ++i) {
        words += joined(i == 0 ? " " : ", ", std::to_string(lines[i]));
    }
    return lines.size() > most_named
               ? joined(words, " and ", std::to_string(lines.size() - most_named), " more")
               : words;
}

void warn(std::vector<std::size_t>& lines, const Table& table, const std::string& how, const char* one,
          const char* several, config::Warnings& warnings) {
    if (lines.empty()) {
        return;
    }
    std::sort(lines.begin(), lines.end());
    warnings.add(joined(table.file(), ", ", lines_in_words(lines), ": ", std::to_string(lines.size()),
                        lines.size() == 1 ? joined(" tree", one) : joined(" trees", several), how,
                        "; correct tree_id or dbh_cm, or leave the tree out of both tables"));
}

}  // namespace

void GrowthCheck::add_new(double dbh_cm, std::size_t line) {
    if (dbh_cm > least_dbh_cm_ + most_growth_of_new_trees_cm_pyear * years_) {
        too_thick_.push_back(line);
    }
}

void GrowthCheck::add(const MeasuredTree& tree, std::size_t line) {
    const double growth_cm = *tree.end_dbh_cm - tree.dbh_cm;
    const double growth_cm_pyear = growth_cm / years_;
    sum_cm_pyear_ += growth_cm_pyear;
    trees_ += 1.0;
    if (growth_cm_pyear > most_growth_cm_pyear) {
        fast_.push_back(line);
    } else if (growth_cm < -measuring_error_cm) {
        shrunk_.push_back(line);
    }
}

void GrowthCheck::report(const Table& table, config::Warnings& warnings, Problems& problems) {
    if (sum_cm_pyear_ > trees_ * most_growth_cm_pyear) {
        problems.add(ExitCode::data, {table.file()},
                     joined("mean diameter growth of ", config::to_text(std::round(sum_cm_pyear_ / trees_)),
                            " cm a year"),
                     joined(config::to_text(most_growth_cm_pyear), " cm a year or less"),
                     "write dbh_cm in cm in both tables, and check first_year and last_year of site.csv");
        return;
    }
    warn(fast_, table, joined(" more than ", config::to_text(most_growth_cm_pyear), " cm a year in diameter"),
         " grows", " grow", warnings);
    warn(shrunk_, table,
         joined(" by more than ", config::to_text(measuring_error_cm), " cm, the error of a tape"),
         " shrinks", " shrink", warnings);
    if (!too_thick_.empty()) {
        std::sort(too_thick_.begin(), too_thick_.end());
        warnings.add(joined(table.file(), ", ", lines_in_words(too_thick_),
                            ": counted as ingrowth, but thicker than least_dbh_cm and ",
                            config::to_text(most_growth_of_new_trees_cm_pyear),
                            " cm a year; correct tree_id if the tree was measured before, or add it to "
                            "trees.csv if it was overlooked"));
    }
}

}  // namespace coupling::validation::forest_cases::remeasured
