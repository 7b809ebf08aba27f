#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "rockfall/laws/on_face.hpp"
#include "rockfall/terrain/face.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// Where a rock is and how it moves: in flight, or on the ground of its triangle.
///
/// `Motion` is its motion model (motion/models.hpp), which knows the spin of a rock on the ground.
template <class Motion>
struct MovingRock {
    Motion motion;
    Eigen::Vector3d position_m;
    Eigen::Vector3d velocity_mps;
    std::uint32_t triangle;
    bool rolling;
    double spin_radps = 0.0;
    Face kept_face{Plane{Eigen::Vector3d::Zero(), Eigen::Vector2d::Zero()}};
    std::uint32_t kept_of = no_triangle;  ///< the triangle of `kept_face`

    /// The face under the rock. It is kept as long as the rock is over it, which on the ground takes many
    /// short pieces.
    const Face& face(const Terrain& terrain) {
        return kept_of == triangle ? kept_face : keep_face(terrain.plane_of(triangle));
    }
    /// Requires the plane of the triangle.
    const Face& keep_face(const Plane& plane) {
        kept_face = Face{plane};
        kept_of = triangle;
        return kept_face;
    }

    void begin_rolling() {
        rolling = true;
        spin_as_rolling();
        motion.begin_rolling(velocity_mps.norm());
    }

    /// `Piece` is a RollingPiece or its heir.
    template <class Piece>
    void go_to_end_of(const Piece& piece) {
        position_m = piece.position_m(piece.duration_s);
        velocity_mps = piece.velocity_at(piece.duration_s);
        spin_as_rolling();
    }

    void put_on(const Plane& face) { position_m.z() = face.height_m(position_m.x(), position_m.y()); }

    /// Puts the rock on a face and turns its motion into it, speed kept.
    void enter(const Face& face) {
        put_on(face.plane);
        velocity_mps = laid_into(face.normal, velocity_mps);
        spin_as_rolling();
    }

    void slow_down(double factor) {
        velocity_mps *= factor;
        spin_radps *= factor;
    }

private:
    void spin_as_rolling() { spin_radps = motion.rolling_spin_radps(velocity_mps.norm()); }
};

}  // namespace rockfall
