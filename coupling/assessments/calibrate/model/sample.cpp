#include "coupling/assessments/calibrate/model/sample.hpp"

#include <limits>

#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::calibrate {
namespace {

double mean_distance_within(const Sample& a) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = i + 1; j < a.size(); ++j) {
            sum += (a.points[i] - a.points[j]).norm();
        }
    }
    return 2.0 * sum / (static_cast<double>(a.size()) * static_cast<double>(a.size()));
}

observed::Distribution distribution_of(const Sample& sample) {
    std::vector<double> values;
    values.reserve(sample.size());
    for (const Eigen::Vector2d& point : sample.points) {
        values.push_back(point.x());
    }
    return observed::Distribution{std::move(values)};
}

}  // namespace

Sample sample_of_values(const std::vector<double>& values) {
    Sample sample;
    sample.points.reserve(values.size());
    for (const double value : values) {
        sample.points.emplace_back(value, 0.0);
    }
    return sample;
}

Sample thinned(const Sample& sample, std::size_t most) {
    if (sample.size() <= most) {
        return sample;
    }
    Sample few{.is_plane = sample.is_plane};
    few.points.reserve(most);
    for (std::size_t i = 0; i < most; ++i) {
        few.points.push_back(sample.points[i * sample.size() / most]);
    }
    return few;
}

double mean_distance(const Sample& a, const Sample& b) {
    double sum = 0.0;
    for (const Eigen::Vector2d& one : a.points) {
        for (const Eigen::Vector2d& other : b.points) {
            sum += (one - other).norm();
        }
    }
    return sum / (static_cast<double>(a.size()) * static_cast<double>(b.size()));
}

double energy_distance(const Sample& a, const Sample& b) {
    if (a.empty() || b.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    if (!a.is_plane) {
        return observed::energy_distance(distribution_of(a), distribution_of(b));
    }
    constexpr std::size_t most_places = 400;
    const Sample few_a = thinned(a, most_places);
    const Sample few_b = thinned(b, most_places);
    return 2.0 * mean_distance(few_a, few_b) - mean_distance_within(few_a) - mean_distance_within(few_b);
}

}  // namespace coupling::calibrate
