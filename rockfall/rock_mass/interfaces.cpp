#include "rockfall/rock_mass/interfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rockfall/rock_mass/broad_phase.hpp"

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

constexpr double same_plane_m = 1e-5;
constexpr double least_area_m2 = 1e-4;

/// The part of a face of one cell that a face of another covers, both in one plane.
std::vector<Vector3d> common_part(const CellFace& face, const CellFace& other) {
    std::vector<Vector3d> rest = face.corners_m;
    for (std::size_t k = 0; k < other.corners_m.size() && rest.size() >= 3; ++k) {
        const Vector3d& from = other.corners_m[k];
        const Vector3d along = other.corners_m[(k + 1) % other.corners_m.size()] - from;
        const Vector3d out = along.cross(other.plane.normal);
        std::vector<Vector3d> kept;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            const Vector3d& a = rest[i];
            const Vector3d& b = rest[(i + 1) % rest.size()];
            const double at_a = out.dot(a - from), at_b = out.dot(b - from);
            if (at_a <= 0.0) {
                kept.push_back(a);
            }
            if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0)) {
                kept.push_back(a + at_a / (at_a - at_b) * (b - a));
            }
        }
        rest = std::move(kept);
    }
    return rest;
}

double area_of_polygon(const std::vector<Vector3d>& corners_m) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < corners_m.size(); ++k) {
        sum += (corners_m[k] - corners_m[0]).cross(corners_m[k + 1] - corners_m[0]);
    }
    return 0.5 * sum.norm();
}

}  // namespace

std::vector<Interface> shared_faces(std::span<const ConvexCell> cells) {
    std::vector<Box3> boxes;
    for (const ConvexCell& cell : cells) {
        Box3 box{Vector3d::Constant(std::numeric_limits<double>::infinity()),
                 Vector3d::Constant(-std::numeric_limits<double>::infinity())};
        for (const CellFace& face : cell.faces) {
            for (const Vector3d& corner_m : face.corners_m) {
                box.low_m = box.low_m.cwiseMin(corner_m - Vector3d::Constant(same_plane_m));
                box.high_m = box.high_m.cwiseMax(corner_m + Vector3d::Constant(same_plane_m));
            }
        }
        boxes.push_back(box);
    }
    std::vector<Interface> found;
    for (const auto& [a, b] : meeting_pairs(boxes, std::vector<std::uint8_t>(cells.size(), 1))) {
        for (const CellFace& face : cells[a].faces) {
            for (const CellFace& other : cells[b].faces) {
                if (face.plane.normal.dot(other.plane.normal) > -1.0 + 1e-9 ||
                    std::abs(face.plane.offset_m + other.plane.offset_m) > same_plane_m) {
                    continue;
                }
                std::vector<Vector3d> polygon = common_part(face, other);
                const double area_m2 = polygon.size() < 3 ? 0.0 : area_of_polygon(polygon);
                if (area_m2 >= least_area_m2) {
                    // Where one of the faces is a joint, both are.
                    found.push_back({a, b, std::move(polygon), face.plane.normal, area_m2,
                                     std::max(face.made_by, other.made_by)});
                }
            }
        }
    }
    return found;
}

}  // namespace rockfall::rock_mass
