#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/terrain/height_noise.hpp"

namespace rockfall {

/// Noise of 1 at points 1 apart leaves this in the slope of the ground that rocks feel, times the square of
/// the radius: the integral of the squared derivative of the tricube over the square of its integral,
/// sqrt(0.9 pi) / 1.157. Along one axis, standard deviation.
inline constexpr double slope_of_noise = 1.454;

/// How wide the ground is that a rock feels as one plane, and how far it may move a point.
struct ContactLaw {
    std::optional<double> given_radius_m{};  ///< everywhere; 0: the heights as they are
    double least_radius_m = 0.0;             ///< of the rock
    double slope_error = 0.0175;             ///< that noise may leave, standard deviation along one axis [-]
    double largest_shift_m = 1.0;

    /// The radius where the heights have this noise: at least that of the rock, and so wide that the slope
    /// error is kept: slope_of_noise * noise * spacing / radius^2.
    [[nodiscard]] double radius_m(const PointNoise& ground) const;
    [[nodiscard]] bool moves_nothing() const {
        return (given_radius_m && !(*given_radius_m > 0.0)) || !(largest_shift_m > 0.0);
    }
    /// The shift, cut off at the largest one. Noise itself is not cut off.
    [[nodiscard]] double cut(double shift_m, const PointNoise& ground) const {
        const double most_m = std::max(largest_shift_m, 4.0 * ground.noise_m);
        return std::clamp(shift_m, -most_m, most_m);
    }
};

/// The surface that a rock of finite size feels: at each point the height of the plane that fits the terrain
/// best (least squares, weighted) around it.
///
/// Its normal is the mean normal of the terrain inside the contact zone, the remedy that Rammer et al. 2010
/// (discussion) propose against point slope angles of the TIN. The weight is Cleveland's (1979) tricube
/// (1 - (d/r)^3)^3 of the plan distance d and falls to zero at the radius r that the law gives the point;
/// what is smaller than the zone goes. Planes stay exactly as they are, at borders and beside holes too. A
/// point whose neighbours fix no plane (none within the radius, or all in one line) stays where it is, so a
/// radius up to the spacing of the points, and 0, return the input.
///
/// No plane is fitted across faces that differ by more than 25 degrees, or by a step, and by more than noise
/// explains, as at the foot or the edge of a wall. There the points count that lie on the face of a half of
/// the zone which is even; where no half is, the zone shrinks.
///
/// Shifts are cut off at the largest one, not eased in: a triangulation has a kink at each edge anyway, and
/// easing in leaves part of the noise behind. A limit of 0 returns the input, infinity sets none.
///
/// Missing heights (NaN) stay missing and have no weight.
config::Raster<double> contact_zone(const config::Raster<double>& heights, const ContactLaw& law,
                                    const HeightNoise& noise);
std::vector<Eigen::Vector3d> contact_zone(std::span<const Eigen::Vector3d> points, const ContactLaw& law,
                                          const HeightNoise& noise);

}  // namespace rockfall
