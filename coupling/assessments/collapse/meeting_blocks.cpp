#include "coupling/assessments/collapse/meeting_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/units/constants.hpp"
#include "rockfall/rock_mass/broad_phase.hpp"

namespace coupling::collapse {
namespace {

using Eigen::Vector3d;
using rockfall::solids::Solid;

/// The largest distance at which a face of one block has all of the other one above it.
double above_a_face_m(const BlockOnWay& block, const BlockOnWay& other) {
    const Eigen::Quaterniond turn = block.attitude.conjugate() * other.attitude;
    const Vector3d shift_m = block.attitude.conjugate() * (other.centre_m - block.centre_m);
    double apart = -std::numeric_limits<double>::infinity();
    for (const rockfall::solids::Face& face : block.solid->hull.faces) {
        const Vector3d normal = turn.conjugate() * face.normal;
        double lowest_m = std::numeric_limits<double>::infinity();
        for (const Vector3d& vertex_m : other.solid->hull.vertices_m) {
            lowest_m = std::min(lowest_m, normal.dot(vertex_m));
        }
        apart = std::max(apart, lowest_m + face.normal.dot(shift_m) - face.offset_m);
    }
    return apart;
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

double apart_m(const BlockOnWay& first, const BlockOnWay& second) {
    return std::max(above_a_face_m(first, second), above_a_face_m(second, first));
}

std::vector<std::uint8_t> singles_near_others(std::span<const BlockOnWay> blocks) {
    std::vector<rockfall::rock_mass::Box3> boxes;
    std::vector<std::uint8_t> asked;
    for (const BlockOnWay& block : blocks) {
        const bool is_there = block.solid != nullptr;
        const double radius_m = is_there ? block.solid->bounding_radius_m : 0.0;
        const Vector3d reach_m = Vector3d::Constant((1.0 + clearance_by_radius) * radius_m + block.way_m);
        boxes.push_back({block.centre_m - reach_m, block.centre_m + reach_m});
        if (!is_there) {
            boxes.back().low_m.x() = std::numeric_limits<double>::infinity();
        }
        asked.push_back(block.is_single ? 1 : 0);
    }
    std::vector<std::uint8_t> near(blocks.size(), 0);
    for (const auto& [first, second] : rockfall::rock_mass::meeting_pairs(boxes, asked)) {
        const BlockOnWay &a = blocks[first], &b = blocks[second];
        const double radii_m = a.solid->bounding_radius_m + b.solid->bounding_radius_m;
        const double reach_m = clearance_by_radius * radii_m + a.way_m + b.way_m;
        if ((a.centre_m - b.centre_m).norm() <= radii_m + reach_m && apart_m(a, b) <= reach_m) {
            near[first] = asked[first] != 0 ? 1 : near[first];
            near[second] = asked[second] != 0 ? 1 : near[second];
        }
    }
    return near;
}

}  // namespace coupling::collapse
