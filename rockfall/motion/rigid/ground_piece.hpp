#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "rockfall/laws/rolling.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall::rigid {

/// An end of a piece on the ground.
struct PieceEnd {
    Eigen::Vector3d underside_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
    double rotation_j = 0.0;

    [[nodiscard]] OwnMotion own() const { return {velocity_mps.squaredNorm(), rotation_j}; }
};

/// The place on the ground above or below a place; that itself off the terrain. `near` is a triangle close
/// by.
inline Eigen::Vector3d on_ground(const Terrain& terrain, const Eigen::Vector3d& place_m, std::uint32_t near) {
    const auto under = terrain.locate(place_m.x(), place_m.y(), near);
    return under ? Eigen::Vector3d{place_m.x(), place_m.y(),
                                   terrain.plane_of(*under).height_m(place_m.x(), place_m.y())}
                 : place_m;
}

/// The straight piece between two ends, as nets and targets take it: its speed at the start is that along the
/// chord. Requires a duration above 0.
inline RollingPiece straight_piece(const PieceEnd& from, const PieceEnd& to, double duration_s) {
    const Eigen::Vector3d moved_m = to.underside_m - from.underside_m;
    const double chord_m = moved_m.norm();
    const Eigen::Vector3d along =
        chord_m > 0.0 ? Eigen::Vector3d{moved_m / chord_m} : Eigen::Vector3d::Zero();
    const double start_mps = std::clamp(from.velocity_mps.dot(along), 0.0, 2.0 * chord_m / duration_s);
    const double gain_mps2 = 2.0 * (chord_m - start_mps * duration_s) / (duration_s * duration_s);
    return {from.underside_m,
            start_mps * along,
            gain_mps2 * along,
            duration_s,
            RollingEnd::piece,
            no_triangle,
            false,
            false,
            from.own(),
            to.own()};
}

}  // namespace rockfall::rigid
