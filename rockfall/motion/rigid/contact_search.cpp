#include "rockfall/motion/rigid/contact_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rockfall/motion/rigid/nearest_point.hpp"
#include "rockfall/solids/ground_contact.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t face_feature = 1U << 20;
constexpr std::uint32_t edge_feature = 1U << 21;
/// A face that lies along a ridge touches it with two of its edges: either counts up to this angle between
/// face and ridge, else the face would rock from one to the other for ever.
constexpr double along_ridge_rad = 2e-3;

/// A contact whose normal is that of a face of the ground up to this angle takes the normal of the face. A
/// block that lies on a face and reaches over its border so has one normal, however it is tilted within
/// overlaps.
constexpr double same_normal_sine = 1e-3;

/// Products of two lengths [m2] above this have the same sign, whatever rounding did.
constexpr double both_sides = 1e-12;

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Deeper than this share of the bounding radius a ridge or peak counts as being on the other side.
constexpr double deepest_share = 0.3;

/// Whether a direction lies on the shorter arc between two others, or that little beyond its ends [rad].
bool lies_between(const Vector3d& direction, const Vector3d& one, const Vector3d& other, double slack_rad) {
    const Vector3d axis = one.cross(other);
    const double least = -slack_rad * axis.norm();
    return one.cross(direction).dot(axis) >= least && direction.cross(other).dot(axis) >= least &&
           direction.dot(one + other) > 0.0;
}

bool is_same_normal(const Vector3d& a, const Vector3d& b) {
    return a.dot(b) > 0.0 && a.cross(b).squaredNorm() < same_normal_sine * same_normal_sine;
}

bool has_corners(const NearTriangle& triangle, const NearTriangle& of, unsigned corners) {
    for (unsigned k = 0; k < 3; ++k) {
        if ((corners & (1U << k)) != 0 && triangle.corners[0] != of.corners[k] &&
            triangle.corners[1] != of.corners[k] && triangle.corners[2] != of.corners[k]) {
            return false;
        }
    }
    return true;
}

/// The nearest point of a ridge or peak is that of the ground only if no triangle that meets there is nearer.
bool is_nearest_of_its_ring(std::span<const NearTriangle> triangles, const NearTriangle& of,
                            const NearestPoint& nearest, const Vector3d& centre_m, double distance_m) {
    constexpr double rounding_m = 1e-12;
    return std::all_of(triangles.begin(), triangles.end(), [&](const NearTriangle& other) {
        return &other == &of || !has_corners(other, of, nearest.corners) ||
               (nearest_on(other, centre_m).point_m - centre_m).norm() >= distance_m - rounding_m;
    });
}

void sphere_touches(const GroundPatch& patch, const PosedBlock& block, double reach_m,
                    std::vector<TouchPoint>& found) {
    const double radius_m = block.solid->bounding_radius_m;
    for (const NearTriangle& triangle : patch.triangles()) {
        const double height_m = triangle.gap_m(block.centre_m);
        if (height_m > radius_m + reach_m || height_m <= 0.0) {
            continue;
        }
        const NearestPoint nearest = nearest_on(triangle, block.centre_m);
        const Vector3d off_m = block.centre_m - nearest.point_m;
        const double distance_m = nearest.corners == 7U ? height_m : off_m.norm();
        if (distance_m > radius_m + reach_m || distance_m <= 0.0 ||
            (nearest.corners != 7U &&
             !is_nearest_of_its_ring(patch.triangles(), triangle, nearest, block.centre_m, distance_m))) {
            continue;
        }
        const Vector3d normal = nearest.corners == 7U ? triangle.normal : Vector3d{off_m / distance_m};
        // The same direction is the same point of the sphere: neighbours in one plane touch once.
        if (std::none_of(found.begin(), found.end(), [&](const TouchPoint& other) {
                return other.normal.cross(normal).squaredNorm() <
                       solids::parallel_sine * solids::parallel_sine;
            })) {
            found.push_back({nearest.point_m, normal, distance_m - radius_m, triangle.number, 0});
        }
    }
}

void vertex_touches(const GroundPatch& patch, const PosedBlock& block, double reach_m,
                    std::vector<TouchPoint>& found) {
    const double radius_m = block.solid->bounding_radius_m;
    for (const NearTriangle& triangle : patch.triangles()) {
        if (triangle.gap_m(block.centre_m) > radius_m + reach_m ||
            triangle.outside_m(block.centre_m) > radius_m) {
            continue;
        }
        for (std::size_t i = 0; i < block.vertices_m.size(); ++i) {
            const Vector3d& vertex_m = block.vertices_m[i];
            const double gap_m = triangle.gap_m(vertex_m);
            if (gap_m > reach_m || triangle.outside_m(vertex_m) > 0.0) {
                continue;
            }
            // On an edge between two triangles of one plane a vertex touches once.
            const auto same = [&](const TouchPoint& other) {
                return other.feature == i && other.normal.cross(triangle.normal).squaredNorm() <
                                                 solids::parallel_sine * solids::parallel_sine;
            };
            if (std::none_of(found.begin(), found.end(), same)) {
                found.push_back({vertex_m - gap_m * triangle.normal, triangle.normal, gap_m, triangle.number,
                                 static_cast<std::uint32_t>(i)});
            }
        }
    }
}

bool lies_on_face(const solids::Hull& hull, const solids::Face& face, const Vector3d& point_m) {
    const std::size_t count = face.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Vector3d& a = hull.vertices_m[face.corners[k]];
        const Vector3d& b = hull.vertices_m[face.corners[(k + 1) % count]];
        if (face.normal.cross(b - a).dot(point_m - a) < 0.0) {
            return false;
        }
    }
    return true;
}

/// Whether the ground around a peak lies below the plane through it with this normal.
bool is_on_top(const GroundPatch& patch, const NearPeak& peak, const Vector3d& normal) {
    constexpr double flat = 1e-9;
    double lowest_m = 0.0;
    for (const Vector3d& neighbour_m : patch.neighbours(peak)) {
        const Vector3d to_m = neighbour_m - peak.point_m;
        const double above_m = normal.dot(to_m);
        if (above_m > flat * to_m.norm()) {
            return false;
        }
        lowest_m = std::min(lowest_m, above_m / to_m.norm());
    }
    return lowest_m < -solids::parallel_sine;
}

/// The normal of a face that lies on a peak, or that of the ground around the peak where it lies on that.
Vector3d normal_on(const GroundPatch& patch, const NearPeak& peak, const Vector3d& normal) {
    const std::span<const Vector3d> corners_m = patch.neighbours(peak);
    for (std::size_t i = 0; i + 1 < corners_m.size(); i += 2) {
        const Vector3d of_ground =
            (corners_m[i] - peak.point_m).cross(corners_m[i + 1] - peak.point_m).normalized();
        if (is_same_normal(normal, of_ground)) {
            return of_ground;
        }
    }
    return normal;
}

void face_touches(const GroundPatch& patch, const PosedBlock& block, double reach_m,
                  std::vector<TouchPoint>& found) {
    const solids::Hull& hull = block.solid->hull;
    const double radius_m = block.solid->bounding_radius_m;
    for (const NearPeak& peak : patch.peaks()) {
        const Vector3d off_m = peak.point_m - block.centre_m;
        if (off_m.squaredNorm() > (radius_m + reach_m) * (radius_m + reach_m)) {
            continue;
        }
        const Vector3d local_m = block.turn.transpose() * off_m;
        std::size_t nearest = 0;
        double gap_m = -no_limit;
        for (std::size_t f = 0; f < hull.faces.size(); ++f) {
            const double height_m = hull.faces[f].normal.dot(local_m) - hull.faces[f].offset_m;
            if (height_m > gap_m) {
                gap_m = height_m;
                nearest = f;
            }
        }
        const Vector3d normal = -block.normals[nearest];
        if (gap_m > reach_m || gap_m < -deepest_share * radius_m || normal.z() <= 0.0 ||
            !is_on_top(patch, peak, normal) || !lies_on_face(hull, hull.faces[nearest], local_m)) {
            continue;
        }
        found.push_back({peak.point_m, normal_on(patch, peak, normal), gap_m, peak.triangle,
                         face_feature + static_cast<std::uint32_t>(nearest)});
    }
}

void edge_touches(const GroundPatch& patch, const PosedBlock& block, double reach_m,
                  std::vector<TouchPoint>& found) {
    const solids::Hull& hull = block.solid->hull;
    const double radius_m = block.solid->bounding_radius_m + std::max(0.0, reach_m);
    for (const NearRidge& ridge : patch.ridges()) {
        const double squared_length = ridge.along_m.squaredNorm();
        const Vector3d to_centre_m = block.centre_m - ridge.from_m;
        const double share = std::clamp(ridge.along_m.dot(to_centre_m) / squared_length, 0.0, 1.0);
        if ((to_centre_m - share * ridge.along_m).squaredNorm() > radius_m * radius_m) {
            continue;
        }
        for (std::size_t e = 0; e < hull.edges.size(); ++e) {
            const solids::Edge& edge = hull.edges[e];
            const Vector3d& start_m = block.vertices_m[edge.from];
            const Vector3d along_edge_m = block.vertices_m[edge.to] - start_m;
            // The normal lies between those of both edges only where each edge parts the other's normals.
            if (ridge.left_normal.dot(along_edge_m) * ridge.right_normal.dot(along_edge_m) > both_sides ||
                block.normals[edge.left].dot(ridge.along_m) * block.normals[edge.right].dot(ridge.along_m) >
                    along_ridge_rad * squared_length) {
                continue;
            }
            const Vector3d across = ridge.along_m.cross(along_edge_m);
            const double squared = across.squaredNorm();
            if (squared <=
                solids::parallel_sine * solids::parallel_sine * squared_length * along_edge_m.squaredNorm()) {
                continue;
            }
            const Vector3d between_m = start_m - ridge.from_m;
            const double on_ridge = between_m.cross(along_edge_m).dot(across) / squared;
            const double on_edge = between_m.cross(ridge.along_m).dot(across) / squared;
            if (on_ridge < 0.0 || on_ridge > 1.0 || on_edge < 0.0 || on_edge > 1.0) {
                continue;
            }
            Vector3d normal = across / std::sqrt(squared);
            if (normal.dot(ridge.left_normal + ridge.right_normal) < 0.0) {
                normal = -normal;
            }
            const double gap_m = normal.dot(between_m);
            if (gap_m > reach_m || gap_m < -deepest_share * radius_m ||
                !lies_between(normal, ridge.left_normal, ridge.right_normal, 0.0) ||
                !lies_between(-normal, block.normals[edge.left], block.normals[edge.right],
                              along_ridge_rad)) {
                continue;
            }
            for (const Vector3d& face_normal : {ridge.left_normal, ridge.right_normal}) {
                normal = is_same_normal(normal, face_normal) ? face_normal : normal;
            }
            found.push_back({ridge.from_m + on_ridge * ridge.along_m, normal, gap_m, ridge.triangle,
                             edge_feature + static_cast<std::uint32_t>(e)});
        }
    }
}

}  // namespace

void PosedBlock::pose(const solids::Solid& of, const Vector3d& place_m, const Eigen::Quaterniond& attitude) {
    solid = &of;
    centre_m = place_m;
    if (of.is_sphere()) {
        vertices_m.clear();
        normals.clear();
        return;
    }
    turn = attitude.toRotationMatrix();
    vertices_m.resize(of.hull.vertices_m.size());
    for (std::size_t i = 0; i < vertices_m.size(); ++i) {
        vertices_m[i] = turn * of.hull.vertices_m[i] + place_m;
    }
    normals.resize(of.hull.faces.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        normals[i] = turn * of.hull.faces[i].normal;
    }
}

void find_touches(const GroundPatch& patch, const PosedBlock& block, double reach_m,
                  std::vector<TouchPoint>& found) {
    found.clear();
    if (block.is_sphere()) {
        sphere_touches(patch, block, reach_m, found);
        return;
    }
    vertex_touches(patch, block, reach_m, found);
    if (!patch.peaks().empty()) {
        face_touches(patch, block, reach_m, found);
        edge_touches(patch, block, reach_m, found);
    }
}

void keep_four(std::vector<TouchPoint>& touches) {
    constexpr std::size_t most = 4;
    if (touches.size() <= most) {
        return;
    }
    const auto take = [&](std::size_t place, auto&& size_of) {
        std::size_t best = place;
        double largest = -no_limit;
        for (std::size_t i = place; i < touches.size(); ++i) {
            const double size = size_of(touches[i]);
            if (size > largest) {
                largest = size;
                best = i;
            }
        }
        std::swap(touches[place], touches[best]);
    };
    take(0, [](const TouchPoint& t) { return -t.gap_m; });
    const Vector3d a = touches[0].point_m;
    take(1, [&](const TouchPoint& t) { return (t.point_m - a).squaredNorm(); });
    const Vector3d b = touches[1].point_m;
    const Vector3d normal = touches[0].normal;
    const auto side = [&](const TouchPoint& t) { return (b - a).cross(t.point_m - a).dot(normal); };
    take(2, [&](const TouchPoint& t) { return std::abs(side(t)); });
    const double sign = side(touches[2]) >= 0.0 ? -1.0 : 1.0;
    take(3, [&](const TouchPoint& t) { return sign * side(t); });
    touches.resize(most);
}

}  // namespace rockfall::rigid
