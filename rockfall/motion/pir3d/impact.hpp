#pragma once

#include <Eigen/Core>

#include "config/random/stream.hpp"
#include "rockfall/laws/soil.hpp"
#include "rockfall/motion/pir3d/law.hpp"

namespace rockfall::pir3d {

/// Width at a speed: d(V) = d_slow + V / V_lim (d_fast - d_slow) up to V_lim, d_fast above (Eqs. 6-9). Each
/// parameter has d_slow, d_fast and V_lim of its own (Table 1).
double width_at(const Width& width, double speed_mps, Uncertainty uncertainty);

/// A deviate from a uniform number on [0, 1): on [-1, 1), or standard normal cut at three deviations.
///
/// The paper does not cut; beyond three lie 0.3 % of the draws, and angles of more than a right angle.
double deviate(double u, Spread spread);

/// What one impact takes from chance, each as a deviate.
struct ImpactDraws {
    double normal = 0.0;
    double tangential = 0.0;
    double sideways = 0.0;
    double upwards = 0.0;
};
ImpactDraws impact_draws(const config::FourUniforms& uniforms, const Law& law);

/// The parameters of one impact.
struct ImpactParameters {
    Restitution restitution;  ///< each on [0, largest_restitution]
    config::Angle sideways;   ///< to the left, within a right angle
    config::Angle upwards;    ///< within a right angle
};
ImpactParameters impact_parameters(const Soil& soil, double speed_mps, const Law& law,
                                   const ImpactDraws& draws);

/// Velocity after an impact: the part along the face times R_T, that into it turned round and times R_N; then
/// turned about the vertical and raised in its vertical plane; and where that would lead into the ground,
/// laid on the face with its speed kept (Cottaz et al. 2010, 2.3.2).
///
/// Never faster than before. Requires a unit normal and velocity . normal < 0.
Eigen::Vector3d reflected(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                          const ImpactParameters& parameters);

/// A velocity laid on a face along the vertical, not scaled.
Eigen::Vector3d vertical_projection(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal);

/// Whether the angle between a velocity and its vertical projection on a face exceeds beta_lim: what parts
/// flight from sliding, after impacts and at edges (Cottaz et al. 2010, 2.3.3).
bool exceeds_threshold(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                       double threshold_tangent);

}  // namespace rockfall::pir3d
