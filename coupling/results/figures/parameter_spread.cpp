#include "coupling/results/figures/parameter_spread.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

struct Moments {
    double mean = 0.0;
    double variance = 0.0;  ///< without chance
};

/// Weights of chance alone first; then those that know of the spread, which take no figure for all of them.
Moments moments_of(std::span<const StratumFigure> figures) {
    Moments found;
    for (int round = 0; round < 2; ++round) {
        double weights = 0.0;
        double squared_weights = 0.0;
        double sum = 0.0;
        for (const StratumFigure& one : figures) {
            const double weight = 1.0 / (one.chance + found.variance);
            weights += weight;
            squared_weights += weight * weight;
            sum += weight * one.value;
        }
        found.mean = sum / weights;
        double scatter = 0.0;
        double expected = 0.0;  // by chance alone
        for (const StratumFigure& one : figures) {
            const double weight = 1.0 / (one.chance + found.variance);
            scatter += weight * (one.value - found.mean) * (one.value - found.mean);
            expected += weight * one.chance * (1.0 - weight / weights);
        }
        found.variance = std::max(0.0, (scatter - expected) / (weights - squared_weights / weights));
    }
    return found;
}

/// What chance could hide: one and a half standard errors of the variance where nothing spreads.
double hidden_variance(std::span<const StratumFigure> figures) {
    double weights = 0.0;
    double squared_weights = 0.0;
    for (const StratumFigure& one : figures) {
        weights += 1.0 / one.chance;
        squared_weights += 1.0 / (one.chance * one.chance);
    }
    const double freedom = static_cast<double>(figures.size()) - 1.0;
    constexpr double standard_errors = 1.5;  // [choice]
    return standard_errors * std::sqrt(2.0 * freedom) / (weights - squared_weights / weights);
}

/// At position share * (n + 1) of sorted values, never beyond the first and the last.
double quantile_of(const std::vector<double>& sorted, double share) {
    const auto count = static_cast<double>(sorted.size());
    const double place = std::clamp(share * (count + 1.0) - 1.0, 0.0, count - 1.0);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Shares of the variance by the slopes of a weighted linear regression.
std::vector<double> shares_of(std::span<const StratumFigure> figures,
                              std::span<const std::vector<double>> draws, const Moments& moments) {
    const auto components = static_cast<Eigen::Index>(draws.front().size());
    const auto rows = static_cast<Eigen::Index>(figures.size());
    std::vector<double> shares(static_cast<std::size_t>(components), 0.0);
    if (moments.variance <= 0.0 || rows <= components + 2) {
        return shares;
    }
    Eigen::MatrixXd x(rows, components + 1);
    Eigen::VectorXd y(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const StratumFigure& one = figures[static_cast<std::size_t>(row)];
        const double root_weight = 1.0 / std::sqrt(one.chance + moments.variance);
        x(row, components) = root_weight;
        for (Eigen::Index c = 0; c < components; ++c) {
            x(row, c) = root_weight * draws[one.stratum][static_cast<std::size_t>(c)];
        }
        y(row) = root_weight * one.value;
    }
    const Eigen::MatrixXd squares = x.transpose() * x;
    const Eigen::LDLT<Eigen::MatrixXd> solved{squares};
    const Eigen::VectorXd slopes = solved.solve(x.transpose() * y);
    const Eigen::MatrixXd inverse = solved.solve(Eigen::MatrixXd::Identity(components + 1, components + 1));
    const double left = (y - x * slopes).squaredNorm() / static_cast<double>(rows - components - 1);
    double sum = 0.0;
    for (Eigen::Index c = 0; c < components; ++c) {
        const double own = slopes(c) * slopes(c) - left * inverse(c, c);
        shares[static_cast<std::size_t>(c)] = std::max(0.0, own);
        sum += std::max(0.0, own);
    }
    const double whole = std::max(sum, moments.variance);
    std::for_each(shares.begin(), shares.end(), [&](double& share) { share /= whole; });
    return shares;
}

}  // namespace

std::optional<ParameterSpread> parameter_spread(std::span<const StratumFigure> figures,
                                                std::span<const std::vector<double>> draws) {
    if (figures.size() < least_strata) {
        return std::nullopt;
    }
    const Moments moments = moments_of(figures);
    const double hidden = hidden_variance(figures);
    const bool is_shown = moments.variance > hidden;
    const double variance = is_shown ? moments.variance : hidden;
    std::vector<double> values;
    for (const StratumFigure& one : figures) {
        values.push_back(std::sqrt(variance / (variance + one.chance)) * (one.value - moments.mean));
    }
    std::sort(values.begin(), values.end());
    // Values that chance made alike are too near to each other to be stretched to that variance.
    constexpr double two_sided_95 = 1.959963984540054;
    const double least = is_shown ? 0.0 : two_sided_95 * std::sqrt(variance);
    return ParameterSpread{
        moments.variance,
        {std::min(-least, quantile_of(values, 0.025)), std::max(least, quantile_of(values, 0.975))},
        is_shown,
        is_shown ? shares_of(figures, draws, moments) : std::vector<double>(draws.front().size(), 0.0)};
}

Interval by_both(double value, const Interval& of_rocks, const ParameterSpread& spread) {
    const auto both = [](double of_chance, double of_draws) {
        return of_draws == 0.0 ? of_chance : std::hypot(of_chance, of_draws);
    };
    const double below = both(value - of_rocks.low, spread.offsets.low);
    const double above = both(of_rocks.high - value, spread.offsets.high);
    return {spread.offsets.low == 0.0 ? of_rocks.low : value - below,
            spread.offsets.high == 0.0 ? of_rocks.high : value + above};
}

}  // namespace coupling
