#include "coupling/assessments/decades/tables/band.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "config/random/quantiles.hpp"

namespace coupling::decades {
namespace {

constexpr double unknown_value = std::numeric_limits<double>::quiet_NaN();

double quantile(const std::vector<double>& sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

/// Of the mean of so many values.
double t_of(std::size_t count, double share_below) {
    return config::students_t_quantile(static_cast<double>(count - 1), share_below);
}

/// Of a sample, without the bias of a normal one.
double skewness_of(std::span<const double> values, double mean) {
    const auto n = static_cast<double>(values.size());
    double squares = 0.0;
    double cubes = 0.0;
    for (const double value : values) {
        const double d = value - mean;
        squares += d * d;
        cubes += d * d * d;
    }
    return cubes / n / std::pow(squares / n, 1.5) * std::sqrt(n * (n - 1.0)) / (n - 2.0);
}

/// How far the mean may lie from the truth in standard deviations, for a quantile t / sqrt(n) of its
/// symmetric law: the inverse of the cubic transformation that takes the skewness out of Student's ratio
/// (Hall 1992, J. R. Statist. Soc. B 54:221, Eq. 2.3 with a = 1/3, b = 1/6).
double hall_inverse(double y, double skewness, double n) {
    if (std::abs(skewness) < 1e-6) {
        return y;
    }
    return 3.0 / skewness * (std::cbrt(1.0 + skewness * (y - skewness / (6.0 * n))) - 1.0);
}

}  // namespace

MeanLaw::MeanLaw(std::span<const double> values) : n_{static_cast<double>(values.size())} {
    assert(!values.empty());
    mean_ = std::accumulate(values.begin(), values.end(), 0.0) / n_;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    // Rounding of the sum makes no interval.
    if (values.size() < 2 || !(*most - *least > 1e-9 * std::abs(mean_))) {
        return;
    }
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - mean_) * (value - mean_);
    }
    deviation_ = std::sqrt(squares / (n_ - 1.0));
    skewness_ = values.size() >= least_for_skewness ? skewness_of(values, mean_) : 0.0;
}

double MeanLaw::at(double probability) const {
    return has_width() ? at_students(config::students_t_quantile(n_ - 1.0, probability)) : mean_;
}

double MeanLaw::at_students(double t) const {
    if (!has_width()) {
        return mean_;
    }
    constexpr double most_times = 3.0;  // as wide; more changes coverage by less than 1 % [choice]
    const double y = t / std::sqrt(n_);
    const double widest = most_times * std::abs(y);
    return mean_ + deviation_ * std::clamp(-hall_inverse(-y, skewness_, n_), -widest, widest);
}

Band band_of(std::vector<double> values, const Bounds& bounds) {
    const MeanLaw law{values};
    Band band;
    band.mean = law.mean();
    band.low = band.high = band.p05 = band.p95 = unknown_value;
    std::sort(values.begin(), values.end());
    band.least = values.front();
    band.most = values.back();
    if (values.size() >= least_for_percentiles) {
        band.p05 = quantile(values, 0.05);
        band.p95 = quantile(values, 0.95);
    }
    if (law.has_width()) {
        band.low = std::max(bounds.low, law.at(0.5 * (1.0 - interval_share)));
        band.high = std::min(bounds.high, law.at(0.5 * (1.0 + interval_share)));
    }
    return band;
}

std::optional<std::size_t> replicates_needed(double mean, double deviation) {
    constexpr std::size_t most = 100'000;
    constexpr double share_below = 0.975;
    const auto suffice = [&](std::size_t count) {
        return t_of(count, share_below) * deviation / std::sqrt(static_cast<double>(count)) < std::abs(mean);
    };
    if (!(deviation >= 0.0) || !(std::abs(mean) > 0.0) || !suffice(most)) {
        return std::nullopt;
    }
    std::size_t too_few = 1;
    std::size_t enough = most;
    while (enough - too_few > 1) {
        const std::size_t middle = too_few + (enough - too_few) / 2;
        (suffice(middle) ? enough : too_few) = middle;
    }
    return enough;
}

}  // namespace coupling::decades
