#include "config/random/distributions.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "config/math/elementary.hpp"
#include "config/random/quantiles.hpp"

namespace config {

namespace {

/// Numerator and denominator of a rational function, lowest power first.
struct Rational {
    std::array<double, 8> numerator;
    std::array<double, 8> denominator;

    [[nodiscard]] double operator()(double x) const { return horner(numerator, x) / horner(denominator, x); }

private:
    static double horner(const std::array<double, 8>& c, double x) {
        return ((((((c[7] * x + c[6]) * x + c[5]) * x + c[4]) * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0];
    }
};

// Wichura, M. J. 1988: Algorithm AS 241: the percentage points of the normal distribution.
// Applied Statistics 37, 477-484; routine PPND16.
constexpr Rational near_the_middle{
    {3.3871328727963666080e0, 1.3314166789178437745e+2, 1.9715909503065514427e+3, 1.3731693765509461125e+4,
     4.5921953931549871457e+4, 6.7265770927008700853e+4, 3.3430575583588128105e+4, 2.5090809287301226727e+3},
    {1.0, 4.2313330701600911252e+1, 6.8718700749205790830e+2, 5.3941960214247511077e+3,
     2.1213794301586595867e+4, 3.9307895800092710610e+4, 2.8729085735721942674e+4, 5.2264952788528545610e+3}};
constexpr Rational in_the_tail{
    {1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0, 3.64784832476320460504e0,
     1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2,
     7.74545014278341407640e-4},
    {1.0, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
     1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4,
     1.05075007164441684324e-9}};
constexpr Rational far_in_the_tail{
    {6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0, 2.96560571828504891230e-1,
     2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5,
     2.01033439929228813265e-7},
    {1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
     7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7,
     2.04426310338993978564e-15}};

/// A number to 48 of its 53 bits: what a library computes may differ in the last one from machine to machine.
double without_last_bits(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::round(mantissa * 0x1p48), exponent - 48);
}

constexpr double smallest_uniform = 0x1p-33;

}  // namespace

double normal_quantile(double u) {
    assert(u >= 0.0 && u <= 1.0);
    const double from_middle = u - 0.5;
    if (std::abs(from_middle) <= 0.425) {
        return from_middle * near_the_middle(0.180625 - from_middle * from_middle);
    }
    const double tail = std::min(u, 1.0 - u);
    if (tail <= 0.0) {
        return std::copysign(std::numeric_limits<double>::infinity(), from_middle);
    }
    const double r = std::sqrt(-ln_of(tail));
    const double distance = r <= 5.0 ? in_the_tail(r - 1.6) : far_in_the_tail(r - 5.0);
    return std::copysign(distance, from_middle);
}

double normal(double u, double mean, double standard_deviation) {
    return mean + standard_deviation * normal_quantile(std::max(u, smallest_uniform));
}

double lognormal(double u, double median, double log_standard_deviation) {
    return median * std::exp(normal(u, 0.0, log_standard_deviation));
}

double exponential(double u, double mean) {
    return -mean * std::log1p(-u);
}

double weibull(double u, double shape, double scale) {
    assert(shape > 0.0 && scale > 0.0);
    return scale * std::pow(-std::log1p(-u), 1.0 / shape);
}

double gamma(double u, double shape, double scale) {
    assert(shape > 0.0 && scale > 0.0);
    return scale * gamma_quantile(shape, u);
}

TruncatedNormal::TruncatedNormal(double cut)
    : cut_{cut}, below_{without_last_bits(0.5 * std::erfc(cut / std::numbers::sqrt2))} {
    assert(cut > 0.0 && std::isfinite(cut));
}

double TruncatedNormal::operator()(double u) const {
    return std::clamp(normal_quantile(below_ + u * (1.0 - 2.0 * below_)), -cut_, cut_);
}

DiscreteDistribution::DiscreteDistribution(std::span<const double> weights) {
    cumulative_.reserve(weights.size());
    double sum = 0.0;
    for (const double weight : weights) {
        assert(weight >= 0.0 && std::isfinite(weight));
        sum += weight;
        cumulative_.push_back(sum);
    }
    assert(sum > 0.0);
}

std::size_t DiscreteDistribution::operator()(double u) const {
    // Rounding may lift the product to the whole sum: the last index of any weight is the first that reaches
    // it.
    const double target = std::min(u * cumulative_.back(), std::nextafter(cumulative_.back(), 0.0));
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), target);
    return static_cast<std::size_t>(found - cumulative_.begin());
}

}  // namespace config
