#include "rockfall/motion/pir3d/impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"

namespace rockfall::pir3d {
namespace {

double around(double mean, double share, double draw) {
    return std::clamp(mean * (1.0 + share * draw), 0.0, largest_restitution);
}

config::Angle within_right_angle(double angle_rad) {
    constexpr double right_rad = 0.5 * std::numbers::pi;
    return config::Angle::from_radians(std::clamp(angle_rad, -right_rad, right_rad));
}

/// Turns a velocity to the left about the vertical and upwards in its vertical plane. Straight up or down it
/// has no such plane and stays as it is.
Eigen::Vector3d turned(const Eigen::Vector3d& velocity_mps, config::Angle sideways, config::Angle upwards) {
    const double plan_mps = velocity_mps.head<2>().norm();
    if (plan_mps <= 0.0) {
        return velocity_mps;
    }
    const config::SinCos turn = config::sin_cos_of(sideways.in_radians());
    const config::SinCos rise = config::sin_cos_of(upwards.in_radians());
    const double x = velocity_mps.x() / plan_mps;
    const double y = velocity_mps.y() / plan_mps;
    const double ahead_mps = rise.cos * plan_mps - rise.sin * velocity_mps.z();
    return {ahead_mps * (turn.cos * x - turn.sin * y), ahead_mps * (turn.sin * x + turn.cos * y),
            rise.sin * plan_mps + rise.cos * velocity_mps.z()};
}

}  // namespace

double width_at(const Width& width, double speed_mps, Uncertainty uncertainty) {
    switch (uncertainty) {
        case Uncertainty::off:
            return 0.0;
        case Uncertainty::constant:
            return width.slow;
        case Uncertainty::by_speed:
            break;
    }
    return width.slow + std::min(speed_mps / width.limit_mps, 1.0) * (width.fast - width.slow);
}

double deviate(double u, Spread spread) {
    static const config::TruncatedNormal within_three_deviations{3.0};
    return spread == Spread::uniform ? 2.0 * u - 1.0 : within_three_deviations(u);
}

ImpactDraws impact_draws(const config::FourUniforms& uniforms, const Law& law) {
    return {deviate(uniforms[0], law.spread), deviate(uniforms[1], law.spread),
            law.turns_sideways ? deviate(uniforms[2], law.spread) : 0.0, deviate(uniforms[3], law.spread)};
}

ImpactParameters impact_parameters(const Soil& soil, double speed_mps, const Law& law,
                                   const ImpactDraws& draws) {
    const auto at_speed = [&](const Width& width) { return width_at(width, speed_mps, law.uncertainty); };
    return {{around(soil.restitution.normal, at_speed(soil.normal_share), draws.normal),
             around(soil.restitution.tangential, at_speed(soil.tangential_share), draws.tangential)},
            within_right_angle(at_speed(soil.sideways_rad) * draws.sideways),
            within_right_angle(at_speed(soil.upwards_rad) * draws.upwards)};
}

Eigen::Vector3d vertical_projection(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal) {
    return {velocity_mps.x(), velocity_mps.y(),
            -(normal.x() * velocity_mps.x() + normal.y() * velocity_mps.y()) / normal.z()};
}

Eigen::Vector3d reflected(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                          const ImpactParameters& parameters) {
    const double along_normal_mps = velocity_mps.dot(normal);
    const Eigen::Vector3d along_face_mps = velocity_mps - along_normal_mps * normal;
    const Eigen::Vector3d mirrored_mps = parameters.restitution.tangential * along_face_mps -
                                         parameters.restitution.normal * along_normal_mps * normal;
    const Eigen::Vector3d leaving_mps = turned(mirrored_mps, parameters.sideways, parameters.upwards);
    if (leaving_mps.dot(normal) >= 0.0) {
        return leaving_mps;
    }
    const Eigen::Vector3d laid = vertical_projection(leaving_mps, normal);
    const double length = laid.norm();
    return length > 0.0 ? Eigen::Vector3d{leaving_mps.norm() / length * laid} : Eigen::Vector3d::Zero();
}

bool exceeds_threshold(const Eigen::Vector3d& velocity_mps, const Eigen::Vector3d& normal,
                       double threshold_tangent) {
    const Eigen::Vector3d laid = vertical_projection(velocity_mps, normal);
    const double along = velocity_mps.dot(laid);
    // |v x w|^2 = |v|^2 |w|^2 - (v . w)^2, written out: the difference would lose its digits at small angles.
    const Eigen::Vector3d across{velocity_mps.y() * laid.z() - velocity_mps.z() * laid.y(),
                                 velocity_mps.z() * laid.x() - velocity_mps.x() * laid.z(),
                                 velocity_mps.x() * laid.y() - velocity_mps.y() * laid.x()};
    return along <= 0.0 || across.norm() > threshold_tangent * along;
}

}  // namespace rockfall::pir3d
