#include "rockfall/rock_mass/convex_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rockfall::rock_mass {

using Eigen::Vector3d;

namespace {

/// Corners nearer to a cutting plane lie on it [m].
constexpr double on_plane_m = 1e-9;

/// Sorts points of a plane around their middle, counter-clockwise seen against the normal, and leaves out
/// those that coincide.
std::vector<Vector3d> around(std::vector<Vector3d> points_m, const Vector3d& normal) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& point_m : points_m) {
        middle += point_m / static_cast<double>(points_m.size());
    }
    const Vector3d u = normal.unitOrthogonal();
    const Vector3d w = normal.cross(u);
    // A number that grows with the angle, without the functions of the C library.
    const auto turn_of = [&](const Vector3d& point_m) {
        const double x = u.dot(point_m - middle), y = w.dot(point_m - middle);
        const double sum = std::abs(x) + std::abs(y);
        const double t = sum > 0.0 ? x / sum : 0.0;
        return y >= 0.0 ? 1.0 - t : 3.0 + t;
    };
    std::stable_sort(points_m.begin(), points_m.end(),
                     [&](const Vector3d& a, const Vector3d& b) { return turn_of(a) < turn_of(b); });
    std::vector<Vector3d> result;
    for (const Vector3d& point_m : points_m) {
        if (result.empty() || (point_m - result.back()).norm() > on_plane_m) {
            result.push_back(point_m);
        }
    }
    while (result.size() > 1 && (result.front() - result.back()).norm() <= on_plane_m) {
        result.pop_back();
    }
    return result;
}

/// The corners of a face at or below a plane. Corners on the plane are noted for the new face.
std::vector<Vector3d> below(const std::vector<Vector3d>& corners_m, const Plane3& plane,
                            std::vector<Vector3d>& on_it) {
    std::vector<Vector3d> kept;
    for (std::size_t i = 0; i < corners_m.size(); ++i) {
        const Vector3d& from = corners_m[i];
        const Vector3d& to = corners_m[(i + 1) % corners_m.size()];
        const double at_from = plane.height_m(from), at_to = plane.height_m(to);
        if (at_from <= on_plane_m) {
            kept.push_back(from);
            if (at_from >= -on_plane_m) {
                on_it.push_back(from);
            }
        }
        if ((at_from < -on_plane_m && at_to > on_plane_m) || (at_from > on_plane_m && at_to < -on_plane_m)) {
            const Vector3d crossing = from + at_from / (at_from - at_to) * (to - from);
            kept.push_back(crossing);
            on_it.push_back(crossing);
        }
    }
    return kept;
}

}  // namespace

ConvexCell box_cell(const Vector3d& low, const Vector3d& high, int made_by) {
    const auto corner = [&](int i) {
        return Vector3d{(i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                        (i & 4) != 0 ? high.z() : low.z()};
    };
    constexpr std::array<std::array<int, 4>, 6> sides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    ConvexCell cell;
    for (int side = 0; side < 6; ++side) {
        CellFace face;
        face.plane.normal = Vector3d::Zero();
        face.plane.normal[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
        face.plane.offset_m = side % 2 == 0 ? -low[side / 2] : high[side / 2];
        face.made_by = made_by;
        for (const int i : sides[static_cast<std::size_t>(side)]) {
            face.corners_m.push_back(corner(i));
        }
        cell.faces.push_back(std::move(face));
    }
    return cell;
}

ConvexCell cell_of(const PlacedBlock& block) {
    ConvexCell cell;
    for (std::size_t f = 0; f < block.faces.size(); ++f) {
        CellFace face{block.faces[f], {}, 0};
        for (const std::uint16_t corner : block.corners_of(f)) {
            face.corners_m.push_back(block.vertices_m[corner]);
        }
        cell.faces.push_back(std::move(face));
    }
    return cell;
}

ConvexCell cell_of(const solids::Hull& hull, int made_by) {
    ConvexCell cell;
    for (const solids::Face& given : hull.faces) {
        CellFace face{{given.normal, given.offset_m}, {}, made_by};
        for (const std::uint32_t corner : given.corners) {
            face.corners_m.push_back(hull.vertices_m[corner]);
        }
        cell.faces.push_back(std::move(face));
    }
    return cell;
}

ConvexCell part_below(const ConvexCell& cell, const Plane3& given, int made_by) {
    const double length = given.normal.norm();
    if (cell.faces.empty() || length == 0.0) {
        return given.offset_m < 0.0 ? ConvexCell{} : cell;
    }
    const Plane3 plane{given.normal / length, given.offset_m / length};
    const Span1 extent = extent_along(cell, plane.normal);
    if (extent.high <= plane.offset_m + on_plane_m) {
        return cell;
    }
    if (extent.low >= plane.offset_m - on_plane_m) {
        return {};
    }
    ConvexCell part;
    std::vector<Vector3d> on_it;
    for (const CellFace& face : cell.faces) {
        std::vector<Vector3d> kept = below(face.corners_m, plane, on_it);
        if (kept.size() >= 3) {
            part.faces.push_back({face.plane, std::move(kept), face.made_by});
        }
    }
    std::vector<Vector3d> cut = around(std::move(on_it), plane.normal);
    if (cut.size() >= 3) {
        part.faces.push_back({plane, std::move(cut), made_by});
    }
    return part.faces.size() >= 4 ? part : ConvexCell{};
}

VolumeAndCentre volume_and_centre(const ConvexCell& cell) {
    const Vector3d origin = cell.faces[0].corners_m[0];
    double six_volumes = 0.0;
    Vector3d first = Vector3d::Zero();
    for (const CellFace& face : cell.faces) {
        const Vector3d a = face.corners_m[0] - origin;
        for (std::size_t k = 1; k + 1 < face.corners_m.size(); ++k) {
            const Vector3d b = face.corners_m[k] - origin, c = face.corners_m[k + 1] - origin;
            const double det = a.dot(b.cross(c));
            six_volumes += det;
            first += det * (a + b + c);
        }
    }
    if (six_volumes <= 0.0) {
        return {0.0, origin};
    }
    return {six_volumes / 6.0, origin + first / (4.0 * six_volumes)};
}

double size_m(const ConvexCell& cell) {
    const double volume_m3 = volume_and_centre(cell).volume_m3;
    double twice_area_m2 = 0.0;
    for (const CellFace& face : cell.faces) {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t k = 1; k + 1 < face.corners_m.size(); ++k) {
            sum += (face.corners_m[k] - face.corners_m[0]).cross(face.corners_m[k + 1] - face.corners_m[0]);
        }
        twice_area_m2 += sum.norm();
    }
    return twice_area_m2 > 0.0 ? std::min(std::cbrt(volume_m3), 12.0 * volume_m3 / twice_area_m2) : 0.0;
}

Span1 extent_along(const ConvexCell& cell, const Vector3d& direction) {
    Span1 extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const CellFace& face : cell.faces) {
        for (const Vector3d& corner_m : face.corners_m) {
            const double at = direction.dot(corner_m);
            extent.low = std::min(extent.low, at);
            extent.high = std::max(extent.high, at);
        }
    }
    return extent;
}

std::vector<Vector3d> corners_of(const ConvexCell& cell) {
    std::vector<Vector3d> corners;
    for (const CellFace& face : cell.faces) {
        corners.insert(corners.end(), face.corners_m.begin(), face.corners_m.end());
    }
    return corners;
}

}  // namespace rockfall::rock_mass
