#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"

namespace coupling::decades {

/// Of a course before its first year with rocks [percent^2]: nothing is known.
inline constexpr double start_variance = 1e4;

/// Uniform and standard normal numbers, one after the other.
class Numbers {
public:
    explicit Numbers(std::uint64_t id) : stream_{{0, 0, 0, id}, config::Purpose::parameter} {}
    double normal() { return config::normal(uniform(), 0.0, 1.0); }
    double uniform() { return stream_.uniform(); }

private:
    config::RandomStream stream_;
};

/// A course that walks at random behind noise, filtered forwards.
struct Walk {
    double log_likelihood = 0.0;
    std::vector<double> level, level_variance, predicted_variance;
};

/// `values`: NaN where none is known. `start`: variance of the course around 0 before anything is known.
Walk filtered(const std::vector<double>& values, const std::vector<double>& noise,
              const std::vector<double>& steps, double start);

/// A course that what is known allows: backward sampling.
std::vector<double> drawn(const Walk& walk, Numbers& numbers);

/// How the deviation of a replicate from the mean course moves: a part that walks, and one that fades.
struct Moves {
    double step_variance = 0.0;  ///< of the walk, in a year
    double fades = 0.0;          ///< variance of the part that fades
    double rho = 0.0;            ///< its correlation a year
};

/// Both parts of a deviation behind the noise of the rocks: what a Kalman filter and backward sampling need
/// beside the values themselves, worked out once.
class DeviationFilter {
public:
    /// `is_known`: whether a year has a value. `events`: years in which the part that walks may jump.
    DeviationFilter(const std::vector<bool>& is_known, const std::vector<double>& noise,
                    const std::vector<double>& gaps, const std::vector<bool>& events, const Moves& moves);

    [[nodiscard]] double log_likelihood(const std::vector<double>& values) const;
    /// A deviation that the values allow.
    [[nodiscard]] std::vector<double> drawn(const std::vector<double>& values, Numbers& numbers) const;

private:
    struct Step {
        double left = 1.0;  ///< of the part that fades, since the year before
        bool is_known = false;
        double variance = 1.0;  ///< of what is seen, before it is seen
        Eigen::Vector2d gain = Eigen::Vector2d::Zero();
        Eigen::Matrix2d back = Eigen::Matrix2d::Zero();     ///< what the next year says of this one
        Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();  ///< a root of the covariance that is left then
    };
    std::vector<Step> steps_;
};

}  // namespace coupling::decades
