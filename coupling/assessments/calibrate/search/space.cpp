#include "coupling/assessments/calibrate/search/space.hpp"

#include <algorithm>
#include <cstdint>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/random/latin_hypercube.hpp"
#include "coupling/inputs/parameters/correlated_draws.hpp"

namespace coupling::calibrate {

std::size_t Space::find(const std::string& parameter) const {
    return static_cast<std::size_t>(
        std::find_if(components_.begin(), components_.end(),
                     [&](const ParameterDraws::Component& one) { return one.parameter == parameter; }) -
        components_.begin());
}

std::vector<double> Space::factors_of(const Point& point) const {
    const Point logarithms = logarithms_of(point);
    std::vector<double> factors;
    for (std::size_t i = 0; i < size(); ++i) {
        factors.push_back(config::exp_of(components_[i].width * logarithms[static_cast<Eigen::Index>(i)]));
    }
    return factors;
}

Point Space::logarithms_of(const Point& point) const {
    const std::vector<double> numbers = correlated(components_, {point.begin(), point.end()});
    return Eigen::Map<const Point>(numbers.data(), point.size());
}

bool Space::holds(const Point& point) {
    return (point.array().abs() <= most_deviations).all();
}

double Space::log_density(const Point& point) {
    return -0.5 * point.squaredNorm();
}

std::vector<Point> Space::spread(std::uint64_t seed, std::size_t points) const {
    static const config::TruncatedNormal normal{most_deviations};
    std::vector<std::uint64_t> dimensions(size());
    for (std::size_t i = 0; i < size(); ++i) {
        dimensions[i] = 8 * i;  // apart from those of search/random
    }
    const auto uniforms =
        config::latin_hypercube({.seed = seed, .year = 1}, config::Purpose::parameter, dimensions, points);
    std::vector<Point> spread;
    spread.reserve(points);
    for (const std::vector<double>& of_point : uniforms) {
        Point& point = spread.emplace_back(static_cast<Eigen::Index>(size()));
        for (std::size_t i = 0; i < size(); ++i) {
            point[static_cast<Eigen::Index>(i)] = normal(of_point[i]);
        }
    }
    return spread;
}

Cloud cloud_of(const std::vector<Point>& points, const std::vector<double>& weights) {
    const Eigen::Index size = points.front().size();
    Cloud cloud{Point::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        cloud.mean += weights[i] * points[i];
        sum += weights[i];
    }
    cloud.mean /= sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point off = points[i] - cloud.mean;
        cloud.covariance += weights[i] / sum * off * off.transpose();
    }
    return cloud;
}

}  // namespace coupling::calibrate
