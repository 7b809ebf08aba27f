#include "rockfall/rock_mass/held_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall::rock_mass {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

void HeldOverlap::clear() {
    is_valid_ = false;
    without_slope_ = 0;
}

void HeldOverlap::keep(const Overlap& overlap, const OverlapSlope& slope, const BlockPose& holder,
                       const BlockPose& other, double reach_m, bool second_holds, double slack_m3) {
    const Matrix3d back = holder.attitude.conjugate().toRotationMatrix();
    is_valid_ = true;
    second_holds_ = second_holds;
    steps_ = 0;
    const double side_m = std::sqrt(overlap.area_m2.norm());
    const double slack = slack_m3 / overlap.force_m3.norm();
    most_along_m_ = std::max(held_share_of_side, std::min(slack, 1.0)) * side_m;
    reach_m_ = std::min(reach_m, std::sqrt(0.5) * side_m);
    depth_m3_ = overlap.depth_m3;
    surface_m2_ = overlap.surface_m2;
    friction_radius_m_ = overlap.friction_radius_m;
    arms_m_ = {back * overlap.arms_m[0], back * overlap.arms_m[1]};
    place_m_ = back * (other.centre_m - holder.centre_m);
    attitude_ = holder.attitude.conjugate() * other.attitude;
    force_m3_ = back * overlap.force_m3;
    normal_ = force_m3_.normalized();
    moment_m4_ = back * overlap.moment_m4;
    area_m2_ = back * overlap.area_m2;
    pressure_centre_m_ = back * overlap.pressure_centre_m() + place_m_;
    const double stiffness_m2 =
        -(slope.force_by_shift * overlap.force_m3).dot(overlap.force_m3) / overlap.force_m3.squaredNorm();
    share_of_depth_ =
        overlap.unevenness() > unevenness_that_opens ? held_share_where_it_opens : held_share_of_depth;
    share_of_depth_ = std::max(share_of_depth_, std::min(2.0 * std::sqrt(slack), 3.0));
    most_towards_m_ = stiffness_m2 > 0.0 ? share_of_depth_ * overlap.force_m3.norm() / stiffness_m2 : 0.0;
    slope_.force_by_shift = back * slope.force_by_shift * back.transpose();
    slope_.force_by_turn = back * slope.force_by_turn * back.transpose();
    slope_.moment_by_shift = back * slope.moment_by_shift * back.transpose();
    slope_.moment_by_turn = back * slope.moment_by_turn * back.transpose();
}

bool HeldOverlap::carry_on(const BlockPose& holder, const BlockPose& other, Overlap& overlap) {
    const Matrix3d axes = holder.attitude.toRotationMatrix();
    const Vector3d shift_m = axes.transpose() * (other.centre_m - holder.centre_m) - place_m_;
    const Quaterniond turned = (holder.attitude.conjugate() * other.attitude) * attitude_.conjugate();
    const Vector3d turn = (turned.w() < 0.0 ? -2.0 : 2.0) * turned.vec();
    const Vector3d at_contact_m = shift_m + turn.cross(pressure_centre_m_ - place_m_);
    const double towards_m = std::abs(normal_.dot(at_contact_m)) + turn.norm() * reach_m_;
    const Vector3d change_m3 = slope_.force_by_shift * shift_m + slope_.force_by_turn * turn;
    // In a gully or a wedge a way across the net force changes it most.
    const bool turns_force =
        change_m3.squaredNorm() > share_of_depth_ * share_of_depth_ * force_m3_.squaredNorm();
    const bool would_pull = (force_m3_ + change_m3).dot(normal_) <= 0.0;
    if (turns_force || would_pull || towards_m > most_towards_m_ ||
        at_contact_m.squaredNorm() > most_along_m_ * most_along_m_) {
        is_valid_ = false;
        without_slope_ = steps_ < 2 ? clippings_without_slope : std::uint8_t{0};
        return false;
    }
    steps_ = static_cast<std::uint8_t>(std::min(steps_ + 1, 100));
    overlap.force_m3 = axes * (force_m3_ + change_m3);
    overlap.moment_m4 = axes * (moment_m4_ + slope_.moment_by_shift * shift_m + slope_.moment_by_turn * turn);
    overlap.area_m2 = axes * area_m2_;
    overlap.depth_m3 = depth_m3_;
    overlap.depth_m4 = depth_m3_ * (axes * pressure_centre_m_ + holder.centre_m - other.centre_m);
    overlap.surface_m2 = surface_m2_;
    overlap.friction_radius_m = friction_radius_m_;
    overlap.arms_m = {axes * arms_m_[0], axes * arms_m_[1]};
    return true;
}

}  // namespace rockfall::rock_mass
