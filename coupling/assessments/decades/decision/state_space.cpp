#include "coupling/assessments/decades/decision/state_space.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace coupling::decades {
namespace {

/// Of a jump of a replicate with an event [percent^2]: any that is seen [choice].
constexpr double event_variance = 100.0;

/// Lower triangle; the covariance may be singular.
Eigen::Matrix2d factor_of(const Eigen::Matrix2d& covariance) {
    const double a = std::sqrt(std::max(0.0, covariance(0, 0)));
    const double b = a > 0.0 ? 0.5 * (covariance(1, 0) + covariance(0, 1)) / a : 0.0;
    Eigen::Matrix2d factor;
    factor << a, 0.0, b, std::sqrt(std::max(0.0, covariance(1, 1) - b * b));
    return factor;
}

}  // namespace

Walk filtered(const std::vector<double>& values, const std::vector<double>& noise,
              const std::vector<double>& steps, double start) {
    Walk walk;
    double level = 0.0;
    double variance = start;
    for (std::size_t i = 0; i < values.size(); ++i) {
        variance += steps[i];
        walk.predicted_variance.push_back(variance);
        if (!std::isnan(values[i])) {
            const double sum = variance + noise[i];
            const double error = values[i] - level;
            walk.log_likelihood -= 0.5 * (std::log(sum) + error * error / sum);
            level += variance / sum * error;
            variance *= noise[i] / sum;
        }
        walk.level.push_back(level);
        walk.level_variance.push_back(variance);
    }
    return walk;
}

std::vector<double> drawn(const Walk& walk, Numbers& numbers) {
    std::vector<double> level(walk.level.size());
    level.back() = walk.level.back() + std::sqrt(walk.level_variance.back()) * numbers.normal();
    for (std::size_t i = level.size() - 1; i-- > 0;) {
        const double share = walk.predicted_variance[i + 1] > 0.0
                                 ? walk.level_variance[i] / walk.predicted_variance[i + 1]
                                 : 0.0;
        level[i] = walk.level[i] + share * (level[i + 1] - walk.level[i]) +
                   std::sqrt(std::max(0.0, walk.level_variance[i] * (1.0 - share))) * numbers.normal();
    }
    return level;
}

DeviationFilter::DeviationFilter(const std::vector<bool>& is_known, const std::vector<double>& noise,
                                 const std::vector<double>& gaps, const std::vector<bool>& events,
                                 const Moves& moves) {
    Eigen::Matrix2d covariance = Eigen::Vector2d{start_variance, moves.fades}.asDiagonal();
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        Step step;
        if (i > 0) {
            step.left = std::pow(moves.rho, gaps[i]);
            const Eigen::Matrix2d transition = Eigen::Vector2d{1.0, step.left}.asDiagonal();
            const Eigen::Matrix2d before = covariance;
            covariance = transition * covariance * transition;
            covariance(0, 0) += events[i] ? event_variance : moves.step_variance * gaps[i];
            covariance(1, 1) += moves.fades * (1.0 - step.left * step.left);
            Eigen::Matrix2d predicted = covariance;
            predicted.diagonal().array() += 1e-9;  // the part that fades may be nothing
            steps_.back().back = before * transition * predicted.inverse();
            const Eigen::Matrix2d rest = before - steps_.back().back * transition * before;
            steps_.back().scatter = factor_of(rest);
        }
        step.is_known = is_known[i];
        if (step.is_known) {
            const Eigen::Vector2d with = covariance.rowwise().sum();  // with what is seen: the sum of both
            step.variance = with.sum() + noise[i];
            step.gain = with / step.variance;
            covariance -= with * with.transpose() / step.variance;
        }
        steps_.push_back(step);
    }
    steps_.back().scatter = factor_of(covariance);
}

double DeviationFilter::log_likelihood(const std::vector<double>& values) const {
    double sum = 0.0;
    Eigen::Vector2d state = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const Step& step = steps_[i];
        state.y() *= i > 0 ? step.left : 1.0;
        if (step.is_known) {
            const double error = values[i] - state.sum();
            sum -= 0.5 * (std::log(step.variance) + error * error / step.variance);
            state += step.gain * error;
        }
    }
    return sum;
}

std::vector<double> DeviationFilter::drawn(const std::vector<double>& values, Numbers& numbers) const {
    std::vector<Eigen::Vector2d> states;
    Eigen::Vector2d state = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const Step& step = steps_[i];
        state.y() *= i > 0 ? step.left : 1.0;
        if (step.is_known) {
            state += step.gain * (values[i] - state.sum());
        }
        states.push_back(state);
    }
    std::vector<double> sums(steps_.size());
    for (std::size_t i = steps_.size(); i-- > 0;) {
        const Step& step = steps_[i];
        if (i + 1 < steps_.size()) {
            const Eigen::Vector2d ahead{states[i].x(), steps_[i + 1].left * states[i].y()};
            states[i] += step.back * (state - ahead);
        }
        state = states[i] + step.scatter * Eigen::Vector2d{numbers.normal(), numbers.normal()};
        sums[i] = state.sum();
    }
    return sums;
}

}  // namespace coupling::decades
