#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "coupling/inputs/parameters/parameter_draws.hpp"

namespace coupling::calibrate {

/// Parameter sets as independent standard normal numbers, one for each component: 0 is what the tables say.
/// Cut off at three; logarithms of factors are made of them as runs do it, so that they correlate.
using Point = Eigen::VectorXd;

/// The parameters of a site and what is known of them before.
class Space {
public:
    explicit Space(std::vector<ParameterDraws::Component> components) : components_{std::move(components)} {}

    [[nodiscard]] std::size_t size() const { return components_.size(); }
    [[nodiscard]] const std::vector<ParameterDraws::Component>& components() const { return components_; }
    /// Place of a component; `size()` where there is none of that name.
    [[nodiscard]] std::size_t find(const std::string& parameter) const;
    [[nodiscard]] std::vector<double> factors_of(const Point& point) const;
    /// Logarithms of the factors by their widths: where nothing correlates, the point itself.
    [[nodiscard]] Point logarithms_of(const Point& point) const;
    /// Whether all numbers are within the cut-off.
    [[nodiscard]] static bool holds(const Point& point);
    /// Density before anything is observed, up to a constant.
    [[nodiscard]] static double log_density(const Point& point);
    /// Points that cover it evenly.
    [[nodiscard]] std::vector<Point> spread(std::uint64_t seed, std::size_t points) const;

private:
    std::vector<ParameterDraws::Component> components_;
};

/// Weighted points: mean, covariance.
struct Cloud {
    Point mean;
    Eigen::MatrixXd covariance;
};
Cloud cloud_of(const std::vector<Point>& points, const std::vector<double>& weights);

}  // namespace coupling::calibrate
