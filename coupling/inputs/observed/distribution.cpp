#include "coupling/inputs/observed/distribution.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace coupling::observed {

namespace {

/// Walks both samples upward: calls `step(from, to, difference)` for each stretch between neighbouring values
/// with the difference of the distribution functions on it.
template <class Step>
void walk(std::span<const double> a, std::span<const double> b, Step step) {
    std::size_t i = 0;
    std::size_t j = 0;
    double x = std::min(a[0], b[0]);
    while (i < a.size() || j < b.size()) {
        while (i < a.size() && a[i] <= x) {
            ++i;
        }
        while (j < b.size() && b[j] <= x) {
            ++j;
        }
        const double next_a = i < a.size() ? a[i] : std::numeric_limits<double>::infinity();
        const double next_b = j < b.size() ? b[j] : std::numeric_limits<double>::infinity();
        const double next = std::min({next_a, next_b});
        const double difference = static_cast<double>(i) / static_cast<double>(a.size()) -
                                  static_cast<double>(j) / static_cast<double>(b.size());
        step(x, next, difference);
        x = next;
    }
}

}  // namespace

Distribution::Distribution(std::vector<double> values) : values_{std::move(values)} {
    std::sort(values_.begin(), values_.end());
}

double Distribution::mean() const {
    double sum = 0.0;
    for (const double value : values_) {
        sum += value;
    }
    return sum / static_cast<double>(values_.size());
}

double Distribution::deviation() const {
    const double centre = mean();
    double sum = 0.0;
    for (const double value : values_) {
        sum += (value - centre) * (value - centre);
    }
    return values_.size() < 2 ? std::numeric_limits<double>::quiet_NaN()
                              : std::sqrt(sum / static_cast<double>(values_.size() - 1));
}

double Distribution::quantile(double share) const {
    if (values_.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double place = share * static_cast<double>(values_.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values_.size() - 1);
    return std::lerp(values_[below], values_[above], place - static_cast<double>(below));
}

double largest_distance(const Distribution& a, const Distribution& b) {
    assert(a.count() > 0 && b.count() > 0);
    double largest = 0.0;
    walk(a.values(), b.values(),
         [&](double, double, double difference) { largest = std::max(largest, std::abs(difference)); });
    return largest;
}

double distance_by_chance(std::size_t n, std::size_t m) {
    assert(n > 0 && m > 0);
    constexpr double at_5_percent = 1.358;
    return at_5_percent * std::sqrt(1.0 / static_cast<double>(n) + 1.0 / static_cast<double>(m));
}

double energy_distance(const Distribution& a, const Distribution& b) {
    assert(a.count() > 0 && b.count() > 0);
    double integral = 0.0;
    walk(a.values(), b.values(), [&](double from, double to, double difference) {
        if (std::isfinite(to)) {
            integral += (to - from) * difference * difference;
        }
    });
    return 2.0 * integral;
}

}  // namespace coupling::observed
