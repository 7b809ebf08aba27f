#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cassert>
#include <cstddef>

namespace rockfall::rock_mass {

/// A plane: points with normal . x = offset_m. "Below" is where normal . x is smaller.
struct Plane3 {
    Eigen::Vector3d normal;
    double offset_m;

    [[nodiscard]] double height_m(const Eigen::Vector3d& point_m) const {
        return normal.dot(point_m) - offset_m;
    }
};

/// Most faces of a block, and most corners of a face [-]: polygons that are cut need no memory of their own.
inline constexpr std::size_t most_faces = 48;
inline constexpr std::size_t most_corners = 24;
inline constexpr std::size_t most_corners_cut = most_faces + most_corners + 8;

/// The height over a plane along the points of another one: linear.
struct Height2 {
    Eigen::Vector2d slope;
    double at_origin_m;

    [[nodiscard]] double at(const Eigen::Vector2d& point_m) const {
        return slope.x() * point_m.x() + slope.y() * point_m.y() + at_origin_m;
    }
    [[nodiscard]] Height2 minus(const Height2& other) const {
        return {slope - other.slope, at_origin_m - other.at_origin_m};
    }
};

/// A frame in the plane of a face: two axes that with its normal make a right-handed system.
struct FaceFrame {
    Eigen::Vector3d origin_m;
    Eigen::Vector3d along;
    Eigen::Vector3d across;

    /// Requires a unit normal and a point of the face.
    FaceFrame(const Eigen::Vector3d& point_m, const Eigen::Vector3d& normal)
        : origin_m{point_m}, along{normal.unitOrthogonal()}, across{normal.cross(along)} {}

    [[nodiscard]] Eigen::Vector2d in_plane(const Eigen::Vector3d& point_m) const {
        const Eigen::Vector3d from_m = point_m - origin_m;
        return {along.dot(from_m), across.dot(from_m)};
    }
    [[nodiscard]] Height2 height_over(const Plane3& plane) const {
        return {{along.dot(plane.normal), across.dot(plane.normal)}, plane.height_m(origin_m)};
    }
};

/// A convex polygon in a plane, without memory of its own.
struct Polygon2 {
    std::array<Eigen::Vector2d, most_corners_cut> corners_m;
    std::size_t size = 0;

    void add(const Eigen::Vector2d& corner_m) {
        assert(size < corners_m.size());
        corners_m[size++] = corner_m;
    }
};

/// What a line leaves of a polygon.
enum class Cut { nothing, part, all };

/// The part of a convex polygon on which a height is at most 0, in `result` if it is a part (Sutherland &
/// Hodgman 1974, Commun. ACM 17:32).
inline Cut cut_by(const Height2& height, const Polygon2& polygon, Polygon2& result) {
    std::array<double, most_corners_cut> heights_m;
    std::size_t out = 0;
    for (std::size_t i = 0; i < polygon.size; ++i) {
        heights_m[i] = height.at(polygon.corners_m[i]);
        out += heights_m[i] > 0.0 ? 1 : 0;
    }
    if (out == 0 || out == polygon.size) {
        return out == 0 ? Cut::all : Cut::nothing;
    }
    result.size = 0;
    std::size_t last = polygon.size - 1;
    for (std::size_t i = 0; i < polygon.size; last = i++) {
        const Eigen::Vector2d& corner = polygon.corners_m[i];
        if ((heights_m[i] > 0.0) != (heights_m[last] > 0.0)) {
            const Eigen::Vector2d& before = polygon.corners_m[last];
            result.add(before + heights_m[last] / (heights_m[last] - heights_m[i]) * (corner - before));
        }
        if (heights_m[i] <= 0.0) {
            result.add(corner);
        }
    }
    return result.size < 3 ? Cut::nothing : Cut::part;
}

/// A polygon that lines cut one after the other.
class CutPolygon {
public:
    /// Removes all corners, so that others can be added.
    Polygon2& start() {
        now_ = 0;
        parts_[0].size = 0;
        left_ = parts_.data();
        return parts_[0];
    }
    /// Starts with a polygon that stays where it is.
    void start(const Polygon2& polygon) {
        now_ = 0;
        left_ = &polygon;
    }
    [[nodiscard]] const Polygon2& left() const { return *left_; }
    /// Whether anything is left below a height of 0.
    bool cut(const Height2& height) {
        const Cut what = cut_by(height, *left_, parts_[1 - now_]);
        if (what == Cut::part) {
            now_ = 1 - now_;
            left_ = &parts_[now_];
        }
        return what != Cut::nothing;
    }

private:
    std::array<Polygon2, 2> parts_;
    std::size_t now_ = 0;
    const Polygon2* left_ = nullptr;
};

/// Integrals over pieces of a face: of 1, of the depth and its square, and of the first two times the place
/// in its frame. `spread`: of the depth times the products of the coordinates from the centre of pressure.
struct FaceSums {
    double area_m2 = 0.0;
    double depth_m3 = 0.0;
    double depth_squared_m4 = 0.0;
    Eigen::Vector2d place_m3 = Eigen::Vector2d::Zero();
    Eigen::Vector2d place_by_depth_m4 = Eigen::Vector2d::Zero();
    Eigen::Vector3d spread_m5 = Eigen::Vector3d::Zero();  ///< xx, yy, xy

    /// Adds a polygon whose depth is minus a height: closed forms per triangle.
    void add(const Polygon2& piece, const Height2& height);
    /// The spread of the only polygon that was added.
    void find_spread(const Polygon2& piece, const Height2& height);
};

}  // namespace rockfall::rock_mass
