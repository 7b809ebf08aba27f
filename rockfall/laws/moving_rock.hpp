#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "rockfall/laws/on_face.hpp"
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
    void enter(const Plane& face) {
        put_on(face);
        velocity_mps = laid_into(face, velocity_mps);
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
