#include "rockfall/motion/pir3d/motion.hpp"

#include <algorithm>
#include <cassert>

#include "rockfall/laws/hop.hpp"

namespace rockfall::pir3d {

Contact Motion::touch(const Eigen::Vector3d& velocity_mps, double, const Eigen::Vector3d& normal,
                      const SurfaceType& surface, const config::FourUniforms& draws) const {
    assert(surface.soil);
    const Soil& soil = *surface.soil;
    ImpactParameters parameters =
        impact_parameters(soil, velocity_mps.norm(), law_, impact_draws(draws, law_));
    parameters.restitution = with_losses(parameters.restitution, loss_factor_);
    const Eigen::Vector3d leaving_mps = reflected(velocity_mps, normal, parameters);
    if (exceeds_threshold(leaving_mps, normal, soil.threshold_tangent) &&
        hops_far(leaving_mps, normal, least_hop_m_)) {
        return {Onward::flies, leaving_mps, 0.0};
    }
    return {Onward::rolls, leaving_mps - leaving_mps.dot(normal) * normal, 0.0};
}

EdgeWay Motion::way_over_edge(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& next_normal,
                              const SurfaceType& surface) {
    assert(surface.soil);
    if (!exceeds_threshold(velocity_mps, next_normal, surface.soil->threshold_tangent)) {
        return EdgeWay::goes_on;
    }
    return velocity_mps.dot(next_normal) > 0.0 ? EdgeWay::takes_off : EdgeWay::runs_into;
}

double Motion::friction(const SurfaceType& surface) const {
    assert(surface.soil);
    const Soil& soil = *surface.soil;
    const double share = width_at(soil.friction_share, first_speed_mps_, law_.uncertainty);
    return std::max(0.0, soil.friction * (1.0 + share * friction_draw_));
}

}  // namespace rockfall::pir3d
