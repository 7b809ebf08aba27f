#include "coupling/assessments/compare/runs/figure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/random/quantiles.hpp"

namespace coupling::compare {

Figure over_replicates(FigureKey key, std::map<long long, double> by_replicate) {
    if (by_replicate.empty()) {
        return {.key = std::move(key), .value = std::numeric_limits<double>::quiet_NaN()};
    }
    const auto n = static_cast<double>(by_replicate.size());
    double mean = 0.0;
    for (const auto& [replicate, value] : by_replicate) {
        mean += value / n;
    }
    Figure figure{.key = std::move(key), .value = mean, .is_interval = true};
    if (by_replicate.size() > 1) {
        double squares = 0.0;
        for (const auto& [replicate, value] : by_replicate) {
            squares += (value - mean) * (value - mean);
        }
        const double error = std::sqrt(squares / (n - 1.0) / n);
        // Equal values (no rock arrives, say) say nothing about chance: no interval rather than one of no
        // width.
        if (error > 1e-9 * std::abs(mean) && error > 0.0) {
            const double half = config::students_t_quantile(n - 1.0, 0.975) * error;
            const std::string& quantity = figure.key.quantity;
            const bool is_share = quantity.ends_with("_percent");
            const bool may_be_negative = quantity.empty() || quantity.starts_with("protection") ||
                                         quantity.ends_with("_eur_pha");  // empty: a difference
            // What cannot be is left out of the interval.
            figure.low = may_be_negative ? mean - half : std::max(0.0, mean - half);
            figure.high = is_share ? std::min(100.0, mean + half) : mean + half;
        }
    }
    figure.by_replicate = std::move(by_replicate);
    return figure;
}

}  // namespace coupling::compare
