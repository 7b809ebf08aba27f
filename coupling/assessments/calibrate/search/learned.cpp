#include "coupling/assessments/calibrate/search/learned.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/random/quantiles.hpp"

namespace coupling::calibrate {

double effective_sets(const std::vector<Member>& members) {
    double squares = 0.0;
    for (const Member& member : members) {
        squares += member.weight * member.weight;
    }
    return 1.0 / squares;
}

double learned_by_chance(double effective_sets, std::size_t figures) {
    constexpr double share = 0.05;
    const double taken = std::min(static_cast<double>(figures), 0.5 * effective_sets);
    const double freedom = effective_sets - 1.0 - taken;
    if (!(freedom > 0.0)) {
        return 1.0;
    }
    const double chi_square = 2.0 * config::gamma_quantile(0.5 * freedom, share);
    // The variance of weighted sets is taken about their own mean.
    return 1.0 - std::sqrt(chi_square / freedom * (1.0 - 1.0 / effective_sets));
}

std::vector<Learned> learned_of(const Space& space, const std::vector<Member>& members, std::size_t figures) {
    std::vector<Point> points;
    std::vector<double> weights;
    for (const Member& member : members) {
        points.push_back(space.logarithms_of(member.point));
        weights.push_back(member.weight);
    }
    const Cloud cloud = cloud_of(points, weights);
    // The deviation of a standard normal number that is cut off at 3.
    constexpr double deviation_before = 0.98658;
    const double by_chance = learned_by_chance(effective_sets(members), figures);
    std::vector<Learned> all;
    for (std::size_t i = 0; i < space.size(); ++i) {
        const auto place = static_cast<Eigen::Index>(i);
        std::vector<std::pair<double, double>> order;  // point, weight
        for (std::size_t k = 0; k < points.size(); ++k) {
            order.emplace_back(points[k][place], weights[k]);
        }
        std::sort(order.begin(), order.end());
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
                        .by_chance = by_chance};
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
