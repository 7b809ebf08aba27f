#include "rockfall/motion/classical/motion.hpp"

#include <algorithm>
#include <cmath>

#include "config/random/distributions.hpp"
#include "rockfall/laws/ground_deviation.hpp"
#include "rockfall/laws/hop.hpp"
#include "rockfall/laws/rebound.hpp"
#include "rockfall/motion/classical/friction.hpp"

namespace rockfall::classical {
namespace {

/// A coefficient with its scatter; `u` on [0, 1).
double scattered(double mean, double deviation, double u) {
    static const config::TruncatedNormal within_three_deviations{3.0};
    return std::clamp(mean + deviation * within_three_deviations(u), 0.0, largest_restitution);
}

}  // namespace

Contact Motion::touch(const Eigen::Vector3d& velocity_mps, double, const Eigen::Vector3d& normal,
                      const SurfaceType& surface, const config::FourUniforms& draws) const {
    const Impact impact = split(velocity_mps, normal);
    const Restitution published = with_losses(surface.as_published(), loss_factor_);
    const double r_n = scattered(published.normal, law_.restitution_deviation, draws[0]);
    const double r_t = scattered(published.tangential, law_.restitution_deviation, draws[1]);
    const config::Angle turn =
        config::Angle::from_radians((2.0 * draws[2] - 1.0) * law_.lateral.in_radians());
    const Eigen::Vector3d along_mps = r_t * impact.along_slope_mps * turned(impact.direction, normal, turn);
    const Eigen::Vector3d leaving_mps = along_mps + r_n * impact.into_ground_mps * normal;
    return hops_far(leaving_mps, normal, least_hop_m_) ? Contact{Onward::flies, leaving_mps, 0.0}
                                                       : Contact{Onward::rolls, along_mps, 0.0};
}

double Motion::friction(const SurfaceType& surface) const {
    return friction_of(surface, law_);
}

EdgeWay Motion::way_over_edge(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& next_normal,
                              const SurfaceType&) const {
    const double off_mps = velocity_mps.dot(next_normal);
    const double along_mps = (velocity_mps - off_mps * next_normal).norm();
    if (std::abs(off_mps) <= law_.edge_angle_tangent * along_mps) {
        return EdgeWay::goes_on;
    }
    return off_mps > 0.0 ? EdgeWay::takes_off : EdgeWay::runs_into;
}

}  // namespace rockfall::classical
