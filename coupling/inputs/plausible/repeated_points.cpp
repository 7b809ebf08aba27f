#include "coupling/inputs/plausible/repeated_points.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "config/text/joined.hpp"

namespace coupling::plausible {

using config::joined;

std::size_t points_with_two_heights(std::span<const Eigen::Vector3d> points) {
    constexpr double same_height_m = 0.5;
    std::vector<Eigen::Vector3d> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return std::tuple{a.x(), a.y(), a.z()} < std::tuple{b.x(), b.y(), b.z()};
    });
    std::size_t found = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const bool same_place = sorted[i].head<2>() == sorted[i - 1].head<2>();
        found += same_place && sorted[i].z() - sorted[i - 1].z() > same_height_m ? 1 : 0;
    }
    return found;
}

void judge_repeated_points(std::span<const Eigen::Vector3d> points, const std::string& file,
                           Reading& reading) {
    constexpr double some = 0.1;
    const std::size_t repeated = points_with_two_heights(points);
    if (repeated == 0) {
        return;
    }
    const std::string found = joined(std::to_string(repeated), " of ", counted(points.size(), "point"),
                                     " on the place of another with another height");
    const std::string expected = "one height at each place";
    const std::string advice = "keep the ground points of one survey";
    if (static_cast<double>(repeated) > some * static_cast<double>(points.size())) {
        reading.refuse({file}, found, expected, advice);
    } else {
        reading.warn({file}, found, expected, advice, config::Effect::answer);
    }
}

}  // namespace coupling::plausible
