#include "forest/start/diameters.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "config/random/distributions.hpp"

namespace forest {

namespace {

constexpr double weibull_shape = 3.3;
constexpr double smallest_cm = 1.0;

/// Middle of the i-th of n equal parts of [0, 1].
double quantile_of(std::size_t i, std::size_t n) {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(n);
}

double quadratic_mean(const std::vector<double>& values) {
    double squares = 0.0;
    for (const double value : values) {
        squares += value * value;
    }
    return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Relative diameters; their mean does not matter.
std::vector<double> one_layer(std::size_t trees) {
    std::vector<double> diameters(trees);
    for (std::size_t i = 0; i < trees; ++i) {
        diameters[i] = config::weibull(quantile_of(i, trees), weibull_shape, 1.0);
    }
    return diameters;
}

std::vector<double> two_layers(std::size_t trees) {
    std::vector<double> diameters = one_layer((trees + 1) / 2);
    for (double thinner : one_layer(trees / 2)) {
        diameters.push_back(0.5 * thinner);
    }
    return diameters;
}

/// Exponential beyond the smallest diameter s: mean square s^2 + 2 s m + 2 m^2 with the mean excess m.
std::vector<double> selection_forest(std::size_t trees, double mean_dbh_cm) {
    const double s = smallest_cm;
    const double excess = 0.5 * (std::sqrt(2.0 * mean_dbh_cm * mean_dbh_cm - s * s) - s);
    std::vector<double> diameters(trees);
    for (std::size_t i = 0; i < trees; ++i) {
        diameters[i] = s + (excess > 0.0 ? config::exponential(quantile_of(i, trees), excess) : 0.0);
    }
    return diameters;
}

std::vector<double> relative_diameters(Structure structure, std::size_t trees, double mean_dbh_cm) {
    switch (structure) {
        case Structure::two_layered:
            return two_layers(trees);
        case Structure::plenter:
            return selection_forest(trees, mean_dbh_cm);
        case Structure::even_aged:
        case Structure::groups:
            return one_layer(trees);
    }
    return {};
}

}  // namespace

std::vector<double> stand_diameters_cm(Structure structure, std::size_t trees, double mean_dbh_cm,
                                       double largest_cm) {
    assert(mean_dbh_cm >= smallest_cm && mean_dbh_cm < largest_cm);
    if (trees == 0) {
        return {};
    }
    std::vector<double> diameters = relative_diameters(structure, trees, mean_dbh_cm);
    const double factor = mean_dbh_cm / quadratic_mean(diameters);
    for (double& diameter : diameters) {
        diameter = std::clamp(factor * diameter, smallest_cm, largest_cm);
    }
    std::sort(diameters.begin(), diameters.end(), std::greater<>{});
    return diameters;
}

}  // namespace forest
