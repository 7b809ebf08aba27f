#include "rockfall/rock_mass/bond.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "rockfall/solids/mass_properties.hpp"

namespace rockfall::rock_mass {

using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Area, middle and second moments of a plane polygon with corners in its own plane (sums over triangles).
struct PlaneSums {
    double area = 0.0;
    Vector2d first = Vector2d::Zero();
    double xx = 0.0, yy = 0.0, xy = 0.0;
};

PlaneSums sums_of(std::span<const Vector2d> corners) {
    PlaneSums sums;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector2d& a = corners[i];
        const Vector2d& b = corners[(i + 1) % corners.size()];
        const double cross = a.x() * b.y() - b.x() * a.y();
        sums.area += cross / 2.0;
        sums.first += cross / 6.0 * (a + b);
        sums.xx += cross / 12.0 * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
        sums.yy += cross / 12.0 * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y());
        sums.xy += cross / 24.0 * (2.0 * a.x() * a.y() + a.x() * b.y() + b.x() * a.y() + 2.0 * b.x() * b.y());
    }
    return sums;
}

}  // namespace

PlacedSection section_of(std::span<const Vector3d> corners_m, const Vector3d& normal) {
    assert(corners_m.size() >= 3);
    const Vector3d u = normal.unitOrthogonal();
    const Vector3d w = normal.cross(u);
    const Vector3d origin = corners_m[0];
    std::vector<Vector2d> plane;
    for (const Vector3d& corner_m : corners_m) {
        plane.emplace_back(u.dot(corner_m - origin), w.dot(corner_m - origin));
    }
    PlaneSums sums = sums_of(plane);
    if (sums.area < 0.0) {
        std::reverse(plane.begin(), plane.end());
        sums = sums_of(plane);
    }
    const Vector2d middle = sums.first / sums.area;
    for (Vector2d& corner : plane) {
        corner -= middle;
    }
    sums = sums_of(plane);

    // Principal axes in the plane.
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    tensor << sums.xx, sums.xy, 0.0, sums.xy, sums.yy, 0.0, 0.0, 0.0, 2.0 * (sums.xx + sums.yy);
    const solids::PrincipalAxes principal = solids::principal_axes(tensor);
    const Vector2d first = principal.axes.col(0).head<2>();
    const Vector2d second{-first.y(), first.x()};

    PlacedSection placed;
    placed.middle_m = origin + middle.x() * u + middle.y() * w;
    placed.section.area_m2 = sums.area;
    placed.section.about_second_m4 = principal.moments[0];
    placed.section.about_first_m4 = principal.moments[1];
    for (const Vector2d& corner : plane) {
        placed.section.corners_m.emplace_back(first.dot(corner), second.dot(corner));
        placed.section.reach_m = std::max(placed.section.reach_m, corner.norm());
    }
    Eigen::Matrix3d axes;
    axes.col(0) = first.x() * u + first.y() * w;
    axes.col(1) = second.x() * u + second.y() * w;
    axes.col(2) = normal;
    placed.axes = Quaterniond{axes}.normalized();
    return placed;
}

BondSection disc_section(double radius_m) {
    const double area = std::numbers::pi * radius_m * radius_m;
    const double about = area * radius_m * radius_m / 4.0;
    return {area, about, about, radius_m, {}};
}

BondLoad bond_load(const BondSection& section, const BondStiffness& stiffness, const BondStrain& strain) {
    const double shear = stiffness.shear_npm3 * section.area_m2;
    return {{shear * strain.shift_m.x(), shear * strain.shift_m.y(),
             stiffness.normal_npm3 * section.area_m2 * strain.shift_m.z()},
            {stiffness.normal_npm3 * section.about_first_m4 * strain.turn.x(),
             stiffness.normal_npm3 * section.about_second_m4 * strain.turn.y(),
             stiffness.shear_npm3 * section.polar_m4() * strain.turn.z()}};
}

BondStress bond_stress(const BondSection& section, const BondStiffness& stiffness, const BondStrain& strain) {
    // What bending adds is k_n (theta x y): at a disc's rim R theta_b, at a polygon's corners exact.
    double bending_m = 0.0;
    if (section.corners_m.empty()) {
        bending_m = section.reach_m * strain.turn.head<2>().norm();
    }
    for (const Vector2d& corner : section.corners_m) {
        bending_m = std::max(bending_m, strain.turn.x() * corner.y() - strain.turn.y() * corner.x());
    }
    return {stiffness.normal_npm3 * (strain.shift_m.z() + bending_m),
            stiffness.shear_npm3 *
                (strain.shift_m.head<2>().norm() + std::abs(strain.turn.z()) * section.reach_m),
            std::max(0.0, -stiffness.normal_npm3 * strain.shift_m.z())};
}

bool breaks(const BondStress& stress, const BondStrength& strength, double angle_tan) {
    return stress.tension_pa > strength.tensile_pa ||
           stress.shear_pa > strength.shear_pa + angle_tan * stress.pressure_pa;
}

BondEnergy bond_energy(const BondSection& section, const BondStiffness& stiffness, const BondStrain& strain) {
    const BondLoad load = bond_load(section, stiffness, strain);
    return {0.5 * load.force_n.z() * strain.shift_m.z(),
            0.5 * load.force_n.head<2>().dot(strain.shift_m.head<2>()),
            0.5 * load.moment_nm.head<2>().dot(strain.turn.head<2>()),
            0.5 * load.moment_nm.z() * strain.turn.z()};
}

PlacedStrain strain_of(const Bond& bond, const BlockPose& first, const BlockPose& second) {
    PlacedStrain placed;
    placed.axes = first.attitude * bond.axes_in_first;
    const Vector3d from_m = first.centre_m + first.attitude * bond.anchor_in_first_m;
    placed.anchor_m = second.centre_m + second.attitude * bond.anchor_in_second_m;
    placed.strain.shift_m = placed.axes.conjugate() * (placed.anchor_m - from_m);
    const Quaterniond turn = placed.axes.conjugate() * (second.attitude * bond.axes_in_second);
    const double sign = turn.w() < 0.0 ? -1.0 : 1.0;
    placed.strain.turn = 2.0 * sign * turn.vec();
    placed.half_turn_cosine = sign * turn.w();
    return placed;
}

PairForce bond_force(const Bond& bond, const PlacedStrain& placed, const Mover& first, const Mover& second) {
    const BondLoad load = bond_load(bond.section, bond.stiffness, placed.strain);
    // With theta = 2 sin(half turn), a small turn d changes it by w d + d x theta / 2.
    const Vector3d moment = placed.axes * (placed.half_turn_cosine * load.moment_nm +
                                           0.5 * placed.strain.turn.cross(load.moment_nm));
    PairForce result;
    result.force_n = -(placed.axes * load.force_n);
    result.moment_on_second_nm = (placed.anchor_m - second.centre_m).cross(result.force_n) - moment;
    // The field is fixed to the first block, so that its force acts there at the second one's anchor too.
    result.moment_on_first_nm = -(placed.anchor_m - first.centre_m).cross(result.force_n) + moment;
    return result;
}

PairForce bond_dashpot(Bond& bond, const PlacedStrain& placed, const Mover& first, const Mover& second,
                       double damping_ratio, double effective_mass_kg, double step_s, Losses& losses) {
    const auto relative_mps = [&](const Vector3d& point_m) {
        return Vector3d{second.velocity_at(point_m) - first.velocity_at(point_m)};
    };
    const Vector3d normal = placed.axes * Vector3d::UnitZ();
    const Vector3d speed_mps = relative_mps(placed.anchor_m);
    const double opening_mps = speed_mps.dot(normal);
    const auto resistance = [&](double stiffness_npm3) {
        return 2.0 * damping_ratio * std::sqrt(effective_mass_kg * stiffness_npm3 * bond.section.area_m2);
    };
    const Vector3d force_n = -resistance(bond.stiffness.normal_npm3) * opening_mps * normal -
                             resistance(bond.stiffness.shear_npm3) * (speed_mps - opening_mps * normal);
    losses.dashpot_j -=
        0.5 * step_s * (bond.dashpot_n.dot(relative_mps(bond.point_m)) + force_n.dot(speed_mps));
    bond.dashpot_n = force_n;
    bond.point_m = placed.anchor_m;
    return {force_n, -(placed.anchor_m - first.centre_m).cross(force_n),
            (placed.anchor_m - second.centre_m).cross(force_n)};
}

}  // namespace rockfall::rock_mass
