#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coupling::observed {

/// Values of a sample, sorted.
class Distribution {
public:
    /// Requires finite values.
    explicit Distribution(std::vector<double> values);

    [[nodiscard]] std::size_t count() const { return values_.size(); }
    [[nodiscard]] std::span<const double> values() const { return values_; }
    /// NaN of an empty sample.
    [[nodiscard]] double mean() const;
    /// Standard deviation with n - 1; NaN of fewer than two values.
    [[nodiscard]] double deviation() const;
    /// Straight between the values, at share * (n - 1) from the first (type 7 of Hyndman & Fan 1996, that of
    /// R and numpy). NaN of an empty sample.
    [[nodiscard]] double quantile(double share) const;

private:
    std::vector<double> values_;
};

/// Largest vertical distance between the two empirical distribution functions (Kolmogorov-Smirnov), 0 to 1.
/// Requires values in both.
double largest_distance(const Distribution& a, const Distribution& b);

/// The distance that two samples of one distribution exceed by chance in 5 % of cases:
/// 1.358 sqrt((n + m) / (n m)) (Smirnov 1948). Requires values in both.
double distance_by_chance(std::size_t n, std::size_t m);

/// 2 E|X - Y| - E|X - X'| - E|Y - Y'|, in the unit of the values; 0 for equal distributions (Szekely & Rizzo
/// 2013). In one dimension it is 2 times the integral of (F - G)^2. Requires values in both.
double energy_distance(const Distribution& a, const Distribution& b);

}  // namespace coupling::observed
