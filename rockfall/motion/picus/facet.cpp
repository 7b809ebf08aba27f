#include "rockfall/motion/picus/facet.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"

namespace rockfall::picus {

Eigen::Vector3d facet_normal(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                             const FacetLaw& law, const config::RandomStream& draws, std::uint32_t contact) {
    static const config::TruncatedNormal within_two_deviations{2.0};
    const double speed_mps = velocity_mps.norm();
    const double into = -velocity_mps.dot(normal) / speed_mps;  // sine of the angle of the impact
    const Eigen::Vector3d along_mps = velocity_mps + into * speed_mps * normal;
    const double along = along_mps.norm() / speed_mps;
    const Eigen::Vector3d forward =
        along > 1e-9 ? Eigen::Vector3d{along_mps.normalized()} : normal.unitOrthogonal();
    const Eigen::Vector3d aside = normal.cross(forward);
    const config::SinCos steepest = config::sin_cos_of(2.0 * law.deviation.in_radians());
    const double most_seen = into + along * steepest.sin / steepest.cos;
    for (std::uint32_t i = 0; i < FacetLaw::most_tries; ++i) {
        const config::FourUniforms u = draws.uniforms_of(contact * FacetLaw::most_tries + i);
        const double tilt = std::abs(within_two_deviations(u[0])) * law.deviation.in_radians();
        const config::SinCos lean = config::sin_cos_of(tilt);
        const config::SinCos way =
            law.across_path ? config::SinCos{0.0, 1.0} : config::sin_cos_of(std::numbers::pi * (u[1] - 0.5));
        const double side = u[3] < 0.5 ? -1.0 : 1.0;
        // A facet that leans against the path shows more of itself: its area in sight by that in plan.
        const double seen = into - along * side * way.cos * lean.sin / lean.cos;
        if (u[2] * most_seen < seen) {
            return lean.cos * normal + lean.sin * (side * way.cos * forward + way.sin * aside);
        }
    }
    return normal;
}

Contact on_ground(Contact contact, const Eigen::Vector3d& normal) {
    const double off_mps = contact.velocity_mps.dot(normal);
    if (contact.onward == Onward::rolls || (contact.onward == Onward::flies && off_mps <= 0.0)) {
        contact.velocity_mps -= off_mps * normal;
        contact.onward = Onward::rolls;
    }
    return contact;
}

}  // namespace rockfall::picus
