#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "config/math/elementary.hpp"
#include "config/units/angle.hpp"

namespace rockfall::picus {

/// Length along the ground of a hop that leaves at an angle whose sine and cosine are given, by 2 v^2 / (g
/// n_z). `fall` is the tangent of the slope along the path, positive downhill. On a plane the length is
/// exact.
inline double relative_hop_length(double sine, double cosine, double fall) {
    return sine * std::max(cosine + sine * fall, 0.05);
}

/// No hop stands for more impacts.
inline constexpr double most_impacts_of_a_hop = 20.0;

/// Length of the coming hop by that of one at the angle `usual` with the same speed: how many impacts it
/// stands for [-].
///
/// Probabilities of stopping are those of an impact of the published law (Rammer et al. 2010, Eq. 10). Where
/// hops are longer than the law's there are fewer impacts, and the chance to pass the slope must not rise.
inline double hop_share(const Eigen::Vector3d& leaving_mps, const Eigen::Vector3d& normal,
                        config::Angle usual) {
    const double off_ground_mps = leaving_mps.dot(normal);
    const Eigen::Vector3d along_mps = leaving_mps - off_ground_mps * normal;
    const double along_ground_mps = along_mps.norm();
    const double speed_mps = std::sqrt(off_ground_mps * off_ground_mps + along_ground_mps * along_ground_mps);
    if (!(along_ground_mps > 0.0) || !(normal.z() > 0.0)) {
        return 1.0;
    }
    const double fall = -along_mps.z() / (along_ground_mps * normal.z());
    const config::SinCos up = config::sin_cos_of(usual.in_radians());
    const double usual_length = relative_hop_length(up.sin, up.cos, fall);
    return std::min(
        relative_hop_length(off_ground_mps / speed_mps, along_ground_mps / speed_mps, fall) / usual_length,
        most_impacts_of_a_hop);
}

/// Whether one of `impacts` impacts stops the rock, where one does with `probability`; `draw` on [0, 1).
inline bool is_stopped(double draw, double probability, double impacts) {
    // 1 - (1 - p)^n <= max(1, n) p: most draws need no power.
    if (draw >= std::max(impacts, 1.0) * probability) {
        return false;
    }
    return probability >= 1.0 || draw < 1.0 - config::exp_of(impacts * config::ln_of(1.0 - probability));
}

}  // namespace rockfall::picus
