#include "rockfall/motion/rigid/turning.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Moments that differ by less than this are equal [-].
constexpr double equal_moments = 1e-9;

bool are_equal(double a, double b) {
    return std::abs(a - b) <= equal_moments * std::max(a, b);
}

/// Sine and cosine of any angle, of length 1 to rounding: momenta keep their size.
config::SinCos any_angle(double angle_rad) {
    // The series of sin_cos_of holds up to a right angle: whole turns come off first, then the half is
    // doubled.
    constexpr double turn_rad = 2.0 * std::numbers::pi;
    const double rest_rad = angle_rad - turn_rad * std::floor(angle_rad / turn_rad + 0.5);
    const config::SinCos half = config::sin_cos_of(0.5 * rest_rad);
    const double length = half.sin * half.sin + half.cos * half.cos;
    return {2.0 * half.sin * half.cos / length, (half.cos * half.cos - half.sin * half.sin) / length};
}

Quaterniond turn_about(const Vector3d& axis, double angle_rad) {
    const config::SinCos half = any_angle(0.5 * angle_rad);
    Quaterniond turn;
    turn.w() = half.cos;
    turn.vec() = half.sin * axis;
    return turn;
}

}  // namespace

Turning::Turning(const Vector3d& inertia_kgm2) : inertia_kgm2_{inertia_kgm2}, kind_{Kind::any} {
    const bool low = are_equal(inertia_kgm2[0], inertia_kgm2[1]);
    const bool high = are_equal(inertia_kgm2[1], inertia_kgm2[2]);
    if (low && high) {
        kind_ = Kind::ball;
    } else if (low || high) {
        kind_ = Kind::top;
        axis_ = low ? 2 : 0;
    }
}

void Turning::begin(const solids::Rotation& start) {
    start_ = start;
    reached_ = start;
    steps_done_ = 0.0;
    const double size = start.momentum_nms.norm();
    if (size == 0.0) {
        rate_radps_ = 0.0;
        step_s_ = 0.0;
        return;
    }
    direction_ = start.momentum_in_space_nms() / size;
    rate_radps_ = size / inertia_kgm2_[1];
    // A little less than the longest step, so that rounding never divides one into two.
    constexpr double below_longest = 0.999;
    step_s_ = below_longest * solids::longest_turn_rad * inertia_kgm2_.minCoeff() / size;
}

solids::Rotation Turning::at(double time_s) {
    if (rate_radps_ == 0.0 || time_s <= 0.0) {
        return start_;
    }
    if (kind_ == Kind::any) {
        const double whole = std::floor(time_s / step_s_);
        if (whole < steps_done_) {
            reached_ = start_;
            steps_done_ = 0.0;
        }
        for (; steps_done_ < whole; steps_done_ += 1.0) {
            reached_ = solids::rotate_free(reached_, inertia_kgm2_, step_s_);
        }
        solids::Rotation now =
            solids::rotate_free(reached_, inertia_kgm2_, std::max(0.0, time_s - whole * step_s_));
        // Rounding of many steps must change neither the size of the momentum nor its direction in space.
        now.momentum_nms *= start_.momentum_nms.norm() / now.momentum_nms.norm();
        const Vector3d drifted = now.momentum_in_space_nms().normalized();
        Quaterniond back;
        back.w() = 1.0 + drifted.dot(direction_);
        back.vec() = drifted.cross(direction_);
        now.attitude = (back.normalized() * now.attitude).normalized();
        return now;
    }
    solids::Rotation now = start_;
    now.attitude = turn_about(direction_, rate_radps_ * time_s) * start_.attitude;
    if (kind_ == Kind::top) {
        const double own_radps =
            (1.0 / inertia_kgm2_[axis_] - 1.0 / inertia_kgm2_[1]) * start_.momentum_nms[axis_];
        now.attitude = now.attitude * turn_about(Vector3d::Unit(axis_), own_radps * time_s);
        const config::SinCos turn = any_angle(own_radps * time_s);
        const int next = (axis_ + 1) % 3, last = (axis_ + 2) % 3;
        const double a = start_.momentum_nms[next], b = start_.momentum_nms[last];
        now.momentum_nms[next] = turn.cos * a + turn.sin * b;
        now.momentum_nms[last] = turn.cos * b - turn.sin * a;
    }
    now.attitude.normalize();
    return now;
}

}  // namespace rockfall::rigid
