#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstddef>
#include <utility>

namespace rockfall::rock_mass {

/// A plane: points with normal . x = offset_m. "Below" is where normal . x is smaller.
struct Plane3 {
    Eigen::Vector3d normal;
    double offset_m;

    [[nodiscard]] double height_m(const Eigen::Vector3d& point_m) const {
        return normal.dot(point_m) - offset_m;
    }
};

/// Most faces of a block, and most corners of a face [-]: polygons that are clipped need no memory of their
/// own.
inline constexpr std::size_t most_faces = 48;
inline constexpr std::size_t most_corners = 24;

/// A convex polygon in space, without memory of its own.
struct Polygon {
    std::array<Eigen::Vector3d, most_faces + most_corners + 8> corners_m;
    std::size_t size = 0;

    void add(const Eigen::Vector3d& corner_m) {
        assert(size < corners_m.size());
        corners_m[size++] = corner_m;
    }
};

/// The part of a convex polygon on which `height` is at most 0, in `result`. `height` is a linear function of
/// the place (Sutherland & Hodgman 1974, Commun. ACM 17:32).
template <class Height>
void clip(const Polygon& polygon, const Height& height, Polygon& result) {
    result.size = 0;
    if (polygon.size == 0) {
        return;
    }
    const Eigen::Vector3d* last = &polygon.corners_m[polygon.size - 1];
    double height_of_last = height(*last);
    for (std::size_t i = 0; i < polygon.size; ++i) {
        const Eigen::Vector3d& corner = polygon.corners_m[i];
        const double height_here = height(corner);
        if ((height_here > 0.0) != (height_of_last > 0.0)) {
            const double share = height_of_last / (height_of_last - height_here);
            result.add(*last + share * (corner - *last));
        }
        if (height_here <= 0.0) {
            result.add(corner);
        }
        last = &corner;
        height_of_last = height_here;
    }
    if (result.size < 3) {
        result.size = 0;
    }
}

}  // namespace rockfall::rock_mass
