#include "rockfall/rock_mass/separating_axis.hpp"

#include <limits>
#include <span>

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

constexpr int most_trials = 24;      // [choice]
constexpr int most_refinements = 3;  // [choice]

/// The vertex that lies farthest along a direction.
const Vector3d& farthest(std::span<const Vector3d> vertices_m, const Vector3d& direction) {
    std::size_t best = 0;
    double farthest_m = -std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < vertices_m.size(); ++v) {
        const double along_m = direction.dot(vertices_m[v]);
        if (along_m > farthest_m) {
            farthest_m = along_m;
            best = v;
        }
    }
    return vertices_m[best];
}

/// From the first block to the second one, between the vertices that are closest along an axis.
Vector3d between_m(const Vector3d& axis, const PlacedBlock& first, const PlacedBlock& second) {
    return farthest(second.vertices_m, -axis) - farthest(first.vertices_m, axis);
}

}  // namespace

double apart_along_m(const Vector3d& axis, const PlacedBlock& first, const PlacedBlock& second) {
    return axis.dot(between_m(axis, first, second));
}

std::optional<SeparatingAxis> find_separating_axis(const Vector3d& from, const PlacedBlock& first,
                                                   const PlacedBlock& second) {
    Vector3d axis = from;
    for (int trial = 0; trial < most_trials; ++trial) {
        Vector3d step_m = between_m(axis, first, second);
        const double gap_m = axis.dot(step_m), length_m = step_m.norm();
        if (gap_m > 0.0) {
            SeparatingAxis found{axis, gap_m};
            for (int k = 0; k < most_refinements; ++k) {
                const Vector3d next = step_m.normalized();
                step_m = between_m(next, first, second);
                const double next_m = next.dot(step_m);
                if (next_m <= found.gap_m) {
                    break;
                }
                found = {next, next_m};
            }
            return found;
        }
        if (length_m <= 0.0) {
            return std::nullopt;
        }
        const Vector3d mirror = step_m / length_m;
        axis = (axis - 2.0 * axis.dot(mirror) * mirror).normalized();
    }
    return std::nullopt;
}

}  // namespace rockfall::rock_mass
