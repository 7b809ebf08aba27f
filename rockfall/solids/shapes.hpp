#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

#include "rockfall/solids/hull.hpp"

namespace rockfall::solids {

/// A box with the given sides along x, y, z, centred at the origin. Requires positive sides.
Hull box(const Eigen::Vector3d& sides_m);

/// A double pyramid: base in the plane z = 0 with sides `sides_m.x()` and `sides_m.y()`, an apex half of
/// `sides_m.z()` above and below. With a base of equal diagonals and height it is an octahedron.
Hull double_pyramid(const Eigen::Vector3d& sides_m);

/// A box whose twelve edges are cut off where a plane at 45 deg to both faces takes `cut` of half the
/// shortest side [-], in (0, 0.5]: the rounded block of a river or of a long way down.
Hull chamfered_box(const Eigen::Vector3d& sides_m, double cut);

/// A polyhedron with its vertices on an ellipsoid of the given axes: an icosahedron divided `divisions`
/// times, each triangle into four. Two divisions make 162 vertices, 3.4 % below the volume of the ellipsoid.
Hull ellipsoid(const Eigen::Vector3d& axes_m, int divisions);

/// The hull scaled to a volume, all sides alike.
Hull with_volume(const Hull& hull, double volume_m3);

/// The ten form classes of Sneed & Folk (1958, J. Geol. 66:114).
enum class FormClass : std::uint8_t {
    compact,
    compact_platy,
    compact_bladed,
    compact_elongate,
    platy,
    bladed,
    elongate,
    very_platy,
    very_bladed,
    very_elongate,
};

/// The class of a block with three sides in any order: c/a above 0.7, 0.5, 0.3 (compact, compact-, plain,
/// very-), and (a - b) / (a - c) below 0.33, to 0.67, above (platy, bladed, elongate) for a >= b >= c.
/// Requires positive sides.
FormClass form_class(const Eigen::Vector3d& sides_m);
std::string_view name_of(FormClass form);

}  // namespace rockfall::solids
