#include "forest/climate/normal.hpp"

#include <cmath>

#include "config/math/elementary.hpp"

namespace forest {

namespace {

constexpr double inverse_root_two_pi = 0.398942280401432678;

/// Probability beyond x for 0 <= x < 7.07, times exp(x^2 / 2).
double hart_ratio(double x) {
    double above = 3.52624965998911e-2 * x + 0.700383064443688;
    above = above * x + 6.37396220353165;
    above = above * x + 33.912866078383;
    above = above * x + 112.079291497871;
    above = above * x + 221.213596169931;
    above = above * x + 220.206867912376;
    double below = 8.83883476483184e-2 * x + 1.75566716318264;
    below = below * x + 16.064177579207;
    below = below * x + 86.7807322029461;
    below = below * x + 296.564248779674;
    below = below * x + 637.333633378831;
    below = below * x + 793.826512519948;
    below = below * x + 440.413735824752;
    return above / below;
}

}  // namespace

double normal_density(double z) {
    constexpr double vanishing = 37.0;
    return std::abs(z) > vanishing ? 0.0 : inverse_root_two_pi * config::exp_of(-0.5 * z * z);
}

double normal_probability(double z) {
    constexpr double vanishing = 37.0;
    constexpr double far = 7.07106781186547;
    const double x = std::abs(z);
    double tail = 0.0;
    if (x < far) {
        tail = config::exp_of(-0.5 * z * z) * hart_ratio(x);
    } else if (x <= vanishing) {
        const double fraction = x + 1.0 / (x + 2.0 / (x + 3.0 / (x + 4.0 / (x + 0.65))));
        tail = normal_density(z) / fraction;
    }
    return z > 0.0 ? 1.0 - tail : tail;
}

double mean_above(double mean_degc, double base_degc, double scatter_k) {
    const double z = (mean_degc - base_degc) / scatter_k;
    return scatter_k * (normal_density(z) + z * normal_probability(z));
}

}  // namespace forest
