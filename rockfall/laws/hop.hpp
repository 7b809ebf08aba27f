#pragma once

#include <Eigen/Core>

#include "config/units/constants.hpp"

namespace rockfall {

/// Whether the jump that a velocity leads to is at least so long, along the plane and if the plane went on
/// for ever, or so high above it.
inline bool hops_far(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal, double least_m) {
    // On a plane that goes on for ever the jump takes t = 2 v_n / (g n_z) and leads to t v_t + t^2 g_t / 2.
    // As v_t lies in the plane, v_t . g_t = -g v_t.z.
    const double rising_mps = velocity_mps.dot(normal);
    const double highest_m = 0.5 * rising_mps * rising_mps / (config::gravity_mps2 * normal.z());
    if (highest_m >= least_m) {
        return true;  // straight up and down is a jump too, though it leads nowhere
    }
    const double time_s = 2.0 * rising_mps / (config::gravity_mps2 * normal.z());
    const double squared_along = velocity_mps.squaredNorm() - rising_mps * rising_mps;
    const double falling_mps = rising_mps * normal.z() - velocity_mps.z();
    const double half_fall_mps = 0.5 * config::gravity_mps2 * time_s;
    const double squared_pace = squared_along + 2.0 * half_fall_mps * falling_mps +
                                half_fall_mps * half_fall_mps * (1.0 - normal.z() * normal.z());
    return time_s * time_s * squared_pace >= least_m * least_m;
}

}  // namespace rockfall
