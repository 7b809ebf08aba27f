#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace config {

/// Distributions as pure functions of a uniform number u on [0, 1): one uniform, one value, rising with u.
/// The same u gives the same value everywhere, which the distributions of the standard library do not
/// promise.

/// Standard normal quantile [-], relative error below 1e-13 (Wichura 1988, AS 241, PPND16, with the logarithm
/// of config/math, which is the same on every machine). Minus and plus infinity at u = 0 and u = 1.
double normal_quantile(double u);

/// Normal value; finite for every u, as 0 counts as 2^-33, half a step of a 32-bit uniform.
double normal(double u, double mean, double standard_deviation);

/// Value whose logarithm is normal. The median is the exponential of the mean of the logarithm.
double lognormal(double u, double median, double log_standard_deviation);

/// Requires a mean above 0.
double exponential(double u, double mean);

/// Requires shape and scale above 0.
double weibull(double u, double shape, double scale);

/// Mean is shape * scale. Slow (iterates): for set-up, not for the loop. Requires shape and scale above 0.
double gamma(double u, double shape, double scale);

/// Standard normal restricted to [-cut, cut] standard deviations, by inversion: no draw is thrown away.
class TruncatedNormal {
public:
    /// Requires a finite cut above 0.
    explicit TruncatedNormal(double cut);

    /// [-cut, cut]; times a standard deviation it is a value.
    [[nodiscard]] double operator()(double u) const;
    [[nodiscard]] double cut() const { return cut_; }

private:
    double cut_;
    double below_;  ///< probability of a standard normal below -cut [-]
};

/// An index drawn with the probability of its weight.
class DiscreteDistribution {
public:
    /// Requires finite weights, none below 0 and at least one above 0.
    explicit DiscreteDistribution(std::span<const double> weights);

    /// Never an index of weight 0. Takes time of the order of the logarithm of their number.
    [[nodiscard]] std::size_t operator()(double u) const;
    [[nodiscard]] std::size_t size() const { return cumulative_.size(); }

private:
    std::vector<double> cumulative_;
};

}  // namespace config
