#include "validation/engine/factors/series_estimate.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/random/quantiles.hpp"

namespace coupling::validation {

Estimate SeriesEstimate::interval() const {
    const auto series = static_cast<double>(pulls.size());
    if (pulls.size() < 2) {
        constexpr double unbounded = std::numeric_limits<double>::infinity();
        return {value, -unbounded, unbounded};
    }
    const double squares = std::inner_product(pulls.begin(), pulls.end(), pulls.begin(), 0.0);
    const double half =
        config::students_t_quantile(series - 1.0, 0.975) * std::sqrt(series / (series - 1.0) * squares);
    return {value, value - half, value + half};
}

SeriesEstimate ratio_of(std::span<const double> numerators, std::span<const double> denominators) {
    assert(numerators.size() == denominators.size());
    const double whole = std::accumulate(denominators.begin(), denominators.end(), 0.0);
    SeriesEstimate ratio;
    ratio.pulls.assign(numerators.size(), 0.0);
    if (whole <= 0.0) {
        ratio.value = std::numeric_limits<double>::quiet_NaN();
        return ratio;
    }
    ratio.value = std::accumulate(numerators.begin(), numerators.end(), 0.0) / whole;
    for (std::size_t i = 0; i < numerators.size(); ++i) {
        ratio.pulls[i] = (numerators[i] - ratio.value * denominators[i]) / whole;
    }
    return ratio;
}

SeriesEstimate mean_of(std::span<const SeriesEstimate> figures) {
    assert(!figures.empty());
    const auto count = static_cast<double>(figures.size());
    SeriesEstimate mean;
    mean.pulls.assign(figures.front().pulls.size(), 0.0);
    for (const SeriesEstimate& figure : figures) {
        mean.value += figure.value / count;
        for (std::size_t i = 0; i < mean.pulls.size(); ++i) {
            mean.pulls[i] += figure.pulls[i] / count;
        }
    }
    return mean;
}

SeriesEstimate difference(const SeriesEstimate& a, const SeriesEstimate& b) {
    assert(a.pulls.size() == b.pulls.size());
    SeriesEstimate d{a.value - b.value, a.pulls};
    for (std::size_t i = 0; i < d.pulls.size(); ++i) {
        d.pulls[i] -= b.pulls[i];
    }
    return d;
}

SeriesEstimate one_minus(SeriesEstimate figure) {
    figure.value = 1.0 - figure.value;
    for (double& pull : figure.pulls) {
        pull = -pull;
    }
    return figure;
}

}  // namespace coupling::validation
