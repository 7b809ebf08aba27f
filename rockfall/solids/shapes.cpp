#include "rockfall/solids/shapes.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "config/math/elementary.hpp"
#include "rockfall/solids/mass_properties.hpp"

namespace rockfall::solids {

using Eigen::Vector3d;

Hull box(const Vector3d& sides_m) {
    assert((sides_m.array() > 0.0).all());
    std::vector<Vector3d> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back(0.5 * sides_m.cwiseProduct(Vector3d((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                                              (i & 4) != 0 ? 1 : -1)));
    }
    return convex_hull(corners);
}

Hull double_pyramid(const Vector3d& sides_m) {
    assert((sides_m.array() > 0.0).all());
    const Vector3d half_m = 0.5 * sides_m;
    return convex_hull(
        std::array{Vector3d{half_m.x(), half_m.y(), 0.0}, Vector3d{-half_m.x(), half_m.y(), 0.0},
                   Vector3d{-half_m.x(), -half_m.y(), 0.0}, Vector3d{half_m.x(), -half_m.y(), 0.0},
                   Vector3d{0.0, 0.0, half_m.z()}, Vector3d{0.0, 0.0, -half_m.z()}});
}

Hull chamfered_box(const Vector3d& sides_m, double cut) {
    assert((sides_m.array() > 0.0).all() && cut > 0.0 && cut <= 0.5);
    const Vector3d half_m = 0.5 * sides_m;
    const double cut_m = cut * half_m.minCoeff();
    std::vector<Vector3d> corners;
    for (int i = 0; i < 8; ++i) {
        const Vector3d sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        // Three corners of faces, and where the three cutting planes meet.
        for (int axis = 0; axis < 3; ++axis) {
            Vector3d corner_m = half_m - Vector3d::Constant(cut_m);
            corner_m[axis] = half_m[axis];
            corners.push_back(corner_m.cwiseProduct(sign));
        }
        corners.push_back((half_m - Vector3d::Constant(0.5 * cut_m)).cwiseProduct(sign));
    }
    return convex_hull(corners);
}

Hull ellipsoid(const Vector3d& axes_m, int divisions) {
    assert((axes_m.array() > 0.0).all() && divisions >= 0);
    constexpr double golden = std::numbers::phi;
    std::vector<Vector3d> points;
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-golden, golden}) {
            points.push_back(Vector3d{0.0, a, b}.normalized());
            points.push_back(Vector3d{a, b, 0.0}.normalized());
            points.push_back(Vector3d{b, 0.0, a}.normalized());
        }
    }
    Hull sphere = convex_hull(points);
    for (int i = 0; i < divisions; ++i) {
        points = sphere.vertices_m;
        for (const Edge& edge : sphere.edges) {
            points.push_back((sphere.vertices_m[edge.from] + sphere.vertices_m[edge.to]).normalized());
        }
        sphere = convex_hull(points);
    }
    return scaled(sphere, 0.5 * axes_m);
}

Hull with_volume(const Hull& hull, double volume_m3) {
    assert(volume_m3 > 0.0);
    const double factor = config::pow_of(volume_m3 / volume_integrals(hull).volume_m3, 1.0 / 3.0);
    return scaled(hull, Vector3d::Constant(factor));
}

FormClass form_class(const Vector3d& sides_m) {
    assert((sides_m.array() > 0.0).all());
    std::array<double, 3> s{sides_m.x(), sides_m.y(), sides_m.z()};
    std::sort(s.begin(), s.end());
    const double flat = s[0] / s[2];
    if (flat > 0.7) {
        return FormClass::compact;
    }
    const double elongate = (s[2] - s[1]) / (s[2] - s[0]);
    const int row = flat > 0.5 ? 0 : (flat > 0.3 ? 1 : 2);
    const int column = elongate < 0.33 ? 0 : (elongate <= 0.67 ? 1 : 2);
    return static_cast<FormClass>(1 + 3 * row + column);
}

std::string_view name_of(FormClass form) {
    constexpr std::array<std::string_view, 10> names{
        "compact", "compact-platy", "compact-bladed", "compact-elongate", "platy",
        "bladed",  "elongate",      "very-platy",     "very-bladed",      "very-elongate"};
    return names[static_cast<std::size_t>(form)];
}

}  // namespace rockfall::solids
