#include "coupling/assessments/calibrate/search/learned.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "config/random/quantiles.hpp"

namespace coupling::calibrate {
namespace {

/// So often does a parameter seem to be learned of which nothing is.
constexpr double by_chance_alone = 0.05;

}  // namespace

double effective_sets(const std::vector<Member>& members) {
    double squares = 0.0;
    for (const Member& member : members) {
        squares += member.weight * member.weight;
    }
    return 1.0 / squares;
}

double Chance::narrower() const {
    if (!(degrees > 0.0)) {
        return 1.0;
    }
    const double quantile = 2.0 * config::gamma_quantile(0.5 * degrees, by_chance_alone);
    return std::max(0.0, 1.0 - std::sqrt(mean * quantile / degrees));
}

double Chance::wider() const {
    if (!(degrees > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const double quantile = 2.0 * config::gamma_quantile(0.5 * degrees, 1.0 - by_chance_alone);
    return std::max(0.0, std::sqrt(mean * quantile / degrees) - 1.0);
}

Chance chance_of(const std::vector<double>& values, const std::vector<double>& weights,
                 const Adjustment& adjustment) {
    const double middle = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
    double variance = 0.0;
    double squares = 0.0;  // of weights
    double spread = 0.0;
    double taken = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double off = (values[i] - middle) * (values[i] - middle);
        const double square = weights[i] * weights[i];
        variance += weights[i] * off;
        squares += square;
        spread += square * off;
        taken += square * off * adjustment.pulls[i];
    }
    if (!(variance > 0.0) || !(squares < 1.0) || adjustment.is_capped) {
        return {};
    }
    const double of_mean = spread / variance;  // the variance is taken about the sets' own mean
    const double heavy = of_mean / squares;
    const double scatter = squares * (3.0 * heavy * heavy - 2.0 * heavy + 1.0);
    const double left = 1.0 - adjustment.followed;
    return {.degrees = 2.0 * left * (1.0 - squares) / scatter,
            .mean = (1.0 - of_mean) * (1.0 - taken / variance) / left};
}

std::vector<Learned> learned_of(const Space& space, const std::vector<Member>& members,
                                const Adjustment& adjustment) {
    std::vector<Point> points;
    std::vector<double> weights;
    for (const Member& member : members) {
        points.push_back(space.logarithms_of(member.point));
        weights.push_back(member.weight);
    }
    std::vector<Point> before;
    for (const Point& point : adjustment.before) {
        before.push_back(space.logarithms_of(point));
    }
    const Cloud cloud = cloud_of(points, weights);
    // The deviation of a standard normal number that is cut off at 3.
    constexpr double deviation_before = 0.98658;
    std::vector<Learned> all;
    for (std::size_t i = 0; i < space.size(); ++i) {
        const auto place = static_cast<Eigen::Index>(i);
        std::vector<std::pair<double, double>> order;  // point, weight
        for (std::size_t k = 0; k < points.size(); ++k) {
            order.emplace_back(points[k][place], weights[k]);
        }
        std::sort(order.begin(), order.end());
        std::vector<double> values_before;
        for (const Point& point : before) {
            values_before.push_back(point[place]);
        }
        const Chance chance = chance_of(values_before, weights, adjustment);
        const auto factor_at = [&](double share) {
            double below = 0.0;
            for (const auto& [value, weight] : order) {
                below += weight;
                if (below >= share) {
                    return std::exp(space.components()[i].width * value);
                }
            }
            return std::exp(space.components()[i].width * order.back().first);
        };
        Learned learned{.component = space.components()[i],
                        .median = factor_at(0.5),
                        .low = factor_at(0.05),
                        .high = factor_at(0.95),
                        .learned = 1.0 - std::sqrt(cloud.covariance(place, place)) / deviation_before,
                        .by_chance = chance.narrower(),
                        .wider_by_chance = chance.wider()};
        for (std::size_t k = 0; k < space.size(); ++k) {
            const auto other = static_cast<Eigen::Index>(k);
            const double product = cloud.covariance(place, place) * cloud.covariance(other, other);
            const double correlation =
                product > 0.0 ? cloud.covariance(place, other) / std::sqrt(product) : 0.0;
            if (k != i && std::abs(correlation) > std::abs(learned.correlation)) {
                learned.correlation = correlation;
                learned.partner = space.components()[k].parameter;
            }
        }
        all.push_back(std::move(learned));
    }
    return all;
}

}  // namespace coupling::calibrate
