#include "rockfall/rock_mass/vertex_sides.hpp"

#include <algorithm>
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

void find_sides(const PlacedBlock& foundation, const PlacedBlock& body, VertexSides& sides) {
    std::fill_n(sides.outside.begin(), body.vertices_m.size(), 0);
    std::array<double, most_faces> highest_m;
    for (std::size_t f = 0; f < foundation.faces.size(); ++f) {
        const Plane3& face = foundation.faces[f];
        // The sphere says most of it.
        const double centre_m = face.height_m(body.centre_m);
        highest_m[f] = centre_m + body.radius_m;
        double lowest_m = centre_m - body.radius_m;
        if (highest_m[f] <= 0.0) {
            sides.separation_m = std::max(sides.separation_m, lowest_m);
            continue;
        }
        lowest_m = std::numeric_limits<double>::infinity();
        highest_m[f] = -lowest_m;
        for (std::size_t v = 0; v < body.vertices_m.size(); ++v) {
            const double height_m = face.height_m(body.vertices_m[v]);
            lowest_m = std::min(lowest_m, height_m);
            highest_m[f] = std::max(highest_m[f], height_m);
            sides.outside[v] |= static_cast<std::uint64_t>(height_m > 0.0) << f;
        }
        if (lowest_m > sides.separation_m) {
            sides.second_separation_m = sides.separation_m;
            sides.second_face = sides.highest_face;
            sides.separation_m = lowest_m;
            sides.highest_face = static_cast<std::uint16_t>(f);
            if (lowest_m >= 0.0) {
                return;
            }
        } else if (lowest_m > sides.second_separation_m) {
            sides.second_separation_m = lowest_m;
            sides.second_face = static_cast<std::uint16_t>(f);
        }
    }
    for (std::size_t f = 0; f < foundation.faces.size(); ++f) {
        sides.near |= static_cast<std::uint64_t>(highest_m[f] >= sides.separation_m) << f;
    }
}

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
