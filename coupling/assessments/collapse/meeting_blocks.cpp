#include "coupling/assessments/collapse/meeting_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/units/constants.hpp"

namespace coupling::collapse {
namespace {

using Eigen::Vector3d;
using rockfall::solids::Solid;

/// Whether some face of a block has all of the other one farther above it than a distance.
bool a_face_keeps_apart(const BlockOnWay& block, const BlockOnWay& other, double farther_than_m) {
    const Eigen::Matrix3d back = block.attitude.conjugate().toRotationMatrix();
    const Eigen::Matrix3d into_other = (other.attitude.conjugate() * block.attitude).toRotationMatrix();
    const Vector3d shift_m = back * (other.centre_m - block.centre_m);
    for (const rockfall::solids::Face& face : block.solid->hull.faces) {
        const double lowest_m = farther_than_m + face.offset_m - face.normal.dot(shift_m);
        const Vector3d normal = into_other * face.normal;
        if (std::all_of(other.solid->hull.vertices_m.begin(), other.solid->hull.vertices_m.end(),
                        [&](const Vector3d& vertex_m) { return normal.dot(vertex_m) > lowest_m; })) {
            return true;
        }
    }
    return false;
}

/// Whether two blocks can touch before they are looked at again.
bool are_near(const BlockOnWay& a, const BlockOnWay& b) {
    const double radii_m = a.solid->bounding_radius_m + b.solid->bounding_radius_m;
    const double reach_m = clearance_by_radius * radii_m + a.way_m + b.way_m;
    return (a.centre_m - b.centre_m).squaredNorm() <= (radii_m + reach_m) * (radii_m + reach_m) &&
           !a_face_keeps_apart(a, b, reach_m) && !a_face_keeps_apart(b, a, reach_m);
}

/// How far a block reaches from its centre until then.
double reach_of_m(const BlockOnWay& block) {
    return (1.0 + clearance_by_radius) * block.solid->bounding_radius_m + block.way_m;
}

}  // namespace

/// With T + R given, sqrt(2 T / m) + r sqrt(2 R / I) is at most this.
double fastest_point_mps(const Solid& solid, double kinetic_j) {
    const double radius_m = solid.bounding_radius_m;
    return std::sqrt(2.0 * kinetic_j *
                     (1.0 / solid.mass_kg + radius_m * radius_m / solid.inertia_kgm2.minCoeff()));
}

double point_speed_mps(const Solid& solid, double speed_mps, double rotation_j) {
    const double spin_radps = std::sqrt(2.0 * std::max(0.0, rotation_j) / solid.inertia_kgm2.minCoeff());
    return speed_mps + spin_radps * solid.bounding_radius_m;
}

double way_within_m(double speed_mps, double time_s) {
    return time_s * (speed_mps + config::gravity_mps2 * time_s);
}

std::vector<std::uint8_t> singles_near_others(std::span<const BlockOnWay> blocks) {
    // Few are asked for: each looks at those whose centres lie within its reach and the largest one along x.
    std::vector<std::pair<double, std::uint32_t>> along_x;
    double largest_m = 0.0;
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        if (blocks[i].solid != nullptr) {
            along_x.emplace_back(blocks[i].centre_m.x(), i);
            largest_m = std::max(largest_m, reach_of_m(blocks[i]));
        }
    }
    std::sort(along_x.begin(), along_x.end());
    std::vector<std::uint8_t> near(blocks.size(), 0);
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        if (!blocks[i].is_single) {
            continue;
        }
        const double x_m = blocks[i].centre_m.x(), reach_m = reach_of_m(blocks[i]) + largest_m;
        auto other = std::lower_bound(along_x.begin(), along_x.end(), std::pair{x_m - reach_m, 0U});
        for (; near[i] == 0 && other != along_x.end() && other->first <= x_m + reach_m; ++other) {
            near[i] = other->second != i && are_near(blocks[i], blocks[other->second]) ? 1 : 0;
        }
    }
    return near;
}

}  // namespace coupling::collapse
