#include "forest/start/height_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/math/elementary.hpp"
#include "config/units/constants.hpp"
#include "forest/saplings/saplings.hpp"
#include "forest/stand/height_growth.hpp"
#include "forest/stand/site_height.hpp"

namespace forest {

namespace {

using config::breast_height_m;

double cube_root(double x) {
    return config::pow_of(x, 1.0 / 3.0);
}

}  // namespace

double HeightCurve::height_m(double dbh_cm) const {
    const double share = dbh_cm / (a + b * dbh_cm);
    return breast_height_m + share * share * share;
}

HeightCurve curve_through(double mean_dbh_cm, double mean_height_m) {
    assert(mean_dbh_cm > 0.0 && mean_height_m > 1.5);
    constexpr double taller = 1.25;
    const double at_mean = mean_dbh_cm / cube_root(mean_height_m - breast_height_m);
    const double at_twice = 2.0 * mean_dbh_cm / cube_root(taller * mean_height_m - breast_height_m);
    const double b = (at_twice - at_mean) / mean_dbh_cm;
    return {at_mean - b * mean_dbh_cm, b};
}

HeightFit fit_heights(std::span<const MeasuredHeight> measured) {
    if (measured.size() < fewest_fitted_trees) {
        return {};
    }
    const auto n = static_cast<double>(measured.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    const auto straight = [](const MeasuredHeight& tree) {
        return tree.dbh_cm / cube_root(tree.height_m - breast_height_m);
    };
    for (const MeasuredHeight& tree : measured) {
        mean_x += tree.dbh_cm / n;
        mean_y += straight(tree) / n;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (const MeasuredHeight& tree : measured) {
        xx += (tree.dbh_cm - mean_x) * (tree.dbh_cm - mean_x);
        xy += (tree.dbh_cm - mean_x) * (straight(tree) - mean_y);
    }
    if (xx <= 0.0) {
        return {};
    }
    HeightFit fit{.curve = {.a = mean_y - xy / xx * mean_x, .b = xy / xx}, .trees = measured.size()};
    if (fit.curve.a <= 0.0 || fit.curve.b <= 0.0) {
        return {};
    }
    double squares = 0.0;
    for (const MeasuredHeight& tree : measured) {
        const double miss_m = tree.height_m - fit.curve.height_m(tree.dbh_cm);
        squares += miss_m * miss_m;
    }
    fit.standard_error_m = std::sqrt(squares / (n - 2.0));
    return fit;
}

double height_by_growth(const Species& species, double dbh_cm, double degree_days) {
    constexpr double m_per_cm = 0.01;
    constexpr double usual_light = 0.75;
    constexpr double recruit_cm = 1.0;
    constexpr double step_cm = 0.5;
    const HeightGrowth& law = species.height_growth;
    const double factor = site_height_factor(law, degree_days);
    const double greatest_m = site_height_m(law, degree_days);
    double height_m = recruitment_height_m;
    for (double from_cm = recruit_cm; from_cm < dbh_cm; from_cm += step_cm) {
        const double width_cm = std::min(step_cm, dbh_cm - from_cm);
        const double ratio = height_diameter_ratio(law, from_cm + 0.5 * width_cm, usual_light, factor);
        height_m += m_per_cm * ratio * height_room(height_m, greatest_m) * width_cm;
    }
    return std::min(height_m, law.max_height_m);
}

double greatest_recorded_height_m(const HeightGrowth& law) {
    constexpr double of_species = 1.3;
    return std::round(of_species * law.max_height_m);
}

}  // namespace forest
