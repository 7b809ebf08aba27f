#include "rockfall/solids/free_rotation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rockfall::solids {
namespace {

/// Turns the body about its own axis by the angle a with cos a = (1 - t^2) / (1 + t^2), t = angle / 2:
/// exactly orthogonal, and equal to `angle` up to its cube over 12, which the order of the scheme allows.
void turn_about(Rotation& rotation, int axis, double angle_rad) {
    const double t = 0.5 * angle_rad;
    const double scale = 1.0 / (1.0 + t * t);
    const double cosine = (1.0 - t * t) * scale;
    const double sine = 2.0 * t * scale;

    // The momentum stays in space: in the body it turns the other way.
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double a = rotation.momentum_nms[next], b = rotation.momentum_nms[last];
    rotation.momentum_nms[next] = cosine * a + sine * b;
    rotation.momentum_nms[last] = cosine * b - sine * a;

    const double half_cosine = std::sqrt(scale);
    Eigen::Quaterniond turn{half_cosine, 0.0, 0.0, 0.0};
    turn.vec()[axis] = t * half_cosine;
    rotation.attitude = rotation.attitude * turn;
}

void step(Rotation& rotation, const Eigen::Vector3d& inertia_kgm2, double time_s) {
    const auto turn = [&](int axis, double share) {
        turn_about(rotation, axis, share * time_s * rotation.momentum_nms[axis] / inertia_kgm2[axis]);
    };
    turn(0, 0.5);
    turn(1, 0.5);
    turn(2, 1.0);
    turn(1, 0.5);
    turn(0, 0.5);
}

}  // namespace

Rotation rotate_free(Rotation start, const Eigen::Vector3d& inertia_kgm2, double time_s) {
    assert((inertia_kgm2.array() > 0.0).all() && time_s >= 0.0);
    // |L| / I_min bounds the spin at all times, so the number of steps is fixed beforehand.
    const double turn_rad = start.momentum_nms.norm() / inertia_kgm2.minCoeff() * time_s;
    const double steps = std::max(1.0, std::ceil(turn_rad / longest_turn_rad));
    const double length = start.momentum_nms.norm();
    for (double done = 0.0; done < steps; done += 1.0) {
        step(start, inertia_kgm2, time_s / steps);
        start.attitude.normalize();
    }
    if (length > 0.0) {
        start.momentum_nms *= length / start.momentum_nms.norm();
    }
    return start;
}

}  // namespace rockfall::solids
