#include "rockfall/solids/free_rotation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rockfall::solids {
namespace {

/// Turns the body about its own axis by the angle a with cos a = (1 - t^2) / (1 + t^2), t = angle / 2:
/// exactly orthogonal, and equal to `angle` up to its cube over 12, which the order of the scheme allows. The
/// attitude grows by the root of 1 + t^2.
template <int Axis>
void turn_about(Rotation& rotation, double angle_rad) {
    const double t = 0.5 * angle_rad;
    const double scale = 1.0 / (1.0 + t * t);
    const double cosine = (1.0 - t * t) * scale;
    const double sine = 2.0 * t * scale;

    // The momentum stays in space: in the body it turns the other way.
    constexpr int next = (Axis + 1) % 3, last = (Axis + 2) % 3;
    const double a = rotation.momentum_nms[next], b = rotation.momentum_nms[last];
    rotation.momentum_nms[next] = cosine * a + sine * b;
    rotation.momentum_nms[last] = cosine * b - sine * a;

    // The product with the quaternion of 1 and t about that axis.
    Eigen::Vector4d& q = rotation.attitude.coeffs();  // x, y, z, w
    const double w = q[3], along = q[Axis], at_next = q[next], at_last = q[last];
    q[3] = w - t * along;
    q[Axis] = along + t * w;
    q[next] = at_next + t * at_last;
    q[last] = at_last - t * at_next;
}

/// `rates` are the step divided by the moments of inertia.
void step(Rotation& rotation, const Eigen::Vector3d& rates) {
    turn_about<0>(rotation, 0.5 * rates[0] * rotation.momentum_nms[0]);
    turn_about<1>(rotation, 0.5 * rates[1] * rotation.momentum_nms[1]);
    turn_about<2>(rotation, rates[2] * rotation.momentum_nms[2]);
    turn_about<1>(rotation, 0.5 * rates[1] * rotation.momentum_nms[1]);
    turn_about<0>(rotation, 0.5 * rates[0] * rotation.momentum_nms[0]);
}

}  // namespace

Rotation rotate_free(Rotation start, const Eigen::Vector3d& inertia_kgm2, double time_s) {
    assert((inertia_kgm2.array() > 0.0).all() && time_s >= 0.0);
    // |L| / I_min bounds the spin at all times, so the number of steps is fixed beforehand.
    const double turn_rad = start.momentum_nms.norm() / inertia_kgm2.minCoeff() * time_s;
    const double steps = std::max(1.0, std::ceil(turn_rad / longest_turn_rad));
    const double length = start.momentum_nms.norm();
    const Eigen::Vector3d rates = time_s / steps * inertia_kgm2.cwiseInverse();
    for (double done = 0.0; done < steps; done += 1.0) {
        step(start, rates);
        start.attitude.normalize();
    }
    if (length > 0.0) {
        start.momentum_nms *= length / start.momentum_nms.norm();
    }
    return start;
}

}  // namespace rockfall::solids
