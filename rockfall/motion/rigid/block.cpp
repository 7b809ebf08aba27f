#include "rockfall/motion/rigid/block.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rockfall/motion/rigid/slip_friction.hpp"

namespace rockfall::rigid {
namespace {

using config::gravity_mps2;
using Eigen::Vector3d;

/// Contacts within this gap strike together.
constexpr double together_m = 1e-7;

/// A contact that lasts counts up to this gap. A block that turns about an edge and is pressed to the ground
/// has a centripetal acceleration below gravity's, so half of this is the most that a straight step lifts it.
double lasting_reach_m(double step_s) {
    return gravity_mps2 * step_s * step_s;
}

/// Overlaps beyond this are taken out, a fifth in each step.
constexpr double overlap_m = 1e-4;
constexpr double taken_out = 0.2;

/// A contact that parts no faster than this goes on if the block is pressed to it.
constexpr double parting_mps = 1e-6;

}  // namespace

Block::Block(const SlopeView& slope, const Law& law, const solids::Solid& solid, const Body& start,
             std::uint32_t triangle, BlockScratch& scratch, const Bumps& bumps)
    : slope_{slope},
      law_{law},
      solid_{solid},
      scratch_{scratch},
      bumps_{bumps},
      body_{start},
      triangle_{triangle},
      turning_{solid.inertia_kgm2},
      solver_{law.solver} {
    scratch_.patch.clear();
    ledger_.start_j = body_.kinetic_j(solid_) + body_.potential_j(solid_);
    turning_.begin(body_.rotation);
    flight_ = {body_.centre_m, body_.velocity_mps};
}

double Block::patch_radius_m() const {
    return 1.5 * solid_.bounding_radius_m;
}

/// Finds the triangle under a place and gathers the ground around it. False beyond the terrain.
bool Block::is_over_ground(const Body& body) {
    if (scratch_.patch.covers(body.centre_m.head<2>(), solid_.bounding_radius_m)) {
        return true;
    }
    const auto under = slope_.terrain().locate(body.centre_m.x(), body.centre_m.y(), triangle_);
    if (!under) {
        return false;
    }
    triangle_ = *under;
    scratch_.patch.gather(slope_.terrain(), bumps_, triangle_, body.centre_m.head<2>(), patch_radius_m(),
                          scratch_.marks);
    return true;
}

void Block::pose(const Body& body) {
    scratch_.posed.pose(solid_, body.centre_m, body.rotation.attitude);
}

Velocities Block::velocities_of(const Body& body) const {
    return {body.velocity_mps, body.spin_radps(solid_)};
}

void Block::take_velocities(const Velocities& velocities) {
    body_.velocity_mps = velocities.linear_mps;
    if (law_.in_plane) {
        // Profiles run along x: what leads out of their plane is lost.
        ledger_.other_j += 0.5 * solid_.mass_kg * body_.velocity_mps.y() * body_.velocity_mps.y();
        body_.velocity_mps.y() = 0.0;
    }
    const Vector3d local_radps = body_.rotation.attitude.conjugate() * velocities.spin_radps;
    body_.rotation.momentum_nms = solid_.inertia_kgm2.cwiseProduct(local_radps);
    const double spin = local_radps.norm();
    if (law_.spin_cap_radps > 0.0 && spin > law_.spin_cap_radps) {
        const double before_j = body_.rotation.energy_j(solid_.inertia_kgm2);
        body_.rotation.momentum_nms *= law_.spin_cap_radps / spin;
        ledger_.other_j += before_j - body_.rotation.energy_j(solid_.inertia_kgm2);
    }
}

Ground Block::ground_at(const TouchPoint& touch) const {
    return ground_under(law_, slope_.type_at(touch.triangle, touch.point_m.x(), touch.point_m.y()).block);
}

/// The contacts with what the ground does there.
void Block::take_points(const Velocities& before, double plastic_mps) {
    scratch_.points.clear();
    const bool doubled = law_.double_friction && scratch_.touches.size() >= 2;
    for (const TouchPoint& touch : scratch_.touches) {
        const Ground ground = ground_at(touch);
        const Vector3d arm_m = touch.point_m - body_.centre_m;
        const double into_mps = -before.at(arm_m).dot(touch.normal);
        double restitution = into_mps < plastic_mps ? 0.0 : ground.restitution;
        if (law_.restitution_halved_mps > 0.0) {
            const double ratio = into_mps / law_.restitution_halved_mps;
            restitution /= 1.0 + ratio * ratio;
        }
        scratch_.points.push_back({arm_m, touch.normal,
                                   (doubled ? 2.0 : 1.0) * slip_friction(ground, slip_m_), restitution,
                                   touch.feature});
        beta_ps_ = ground.slip_beta_ps;
        drag_ps_ = ground.drag_ps;
    }
}

/// The percussions at the contacts that were found, with what they cost.
Touchdown Block::percuss(const Velocities& before, const Vector3d& kick_mps) {
    take_points(before, law_.plastic_mps);
    Touchdown touchdown;
    double rolling_arm_m = 0.0;
    for (std::size_t i = 0; i < scratch_.points.size(); ++i) {
        const PercussionPoint& point = scratch_.points[i];
        const TouchPoint& touch = scratch_.touches[i];
        const double into_mps = -before.at(point.arm_m).dot(point.normal);
        if (!touchdown.touched || into_mps > touchdown.into_ground_mps) {
            touchdown.into_ground_mps = into_mps;
            touchdown.point_m = touch.point_m;
            touchdown.triangle = touch.triangle;
        }
        touchdown.touched = true;
        rolling_arm_m =
            std::max(rolling_arm_m, ground_at(touch).rolling_resistance * 0.5 * solid_.diameter_m());
    }
    const BlockMass mass{1.0 / solid_.mass_kg, body_.inverse_inertia(solid_)};
    const PercussionResult result = solver_.solve(mass, before, kick_mps, scratch_.points, rolling_arm_m);
    ++percussions_;
    unsolved_ += result.converged ? 0 : 1;
    ledger_.normal_j -= result.normal_work_j;
    ledger_.friction_j -= result.tangential_work_j;
    ledger_.rolling_j -= result.rolling_work_j;
    take_velocities(result.after);
    if (law_.scar.on) {
        begin_scar(before.linear_mps, kick_mps);
    }
    return touchdown;
}

/// A scar after what all contacts together did to the centre: a corner that meets the ground of a block that
/// turns carries a part of its mass only, and a face shares the block among its corners.
void Block::begin_scar(const Vector3d& along, const Vector3d& kick_mps) {
    Vector3d push_ns = Vector3d::Zero();
    std::size_t hardest = 0;
    for (std::size_t i = 0; i < scratch_.points.size(); ++i) {
        const std::span<const Percussion> percussions = solver_.percussions();
        push_ns += percussions[i].normal_ns * scratch_.points[i].normal;
        hardest = percussions[i].normal_ns > percussions[hardest].normal_ns ? i : hardest;
    }
    const double strength_kpa =
        scratch_.points.empty() ? 0.0 : ground_at(scratch_.touches[hardest]).soil_strength_kpa;
    const double stopped_mps = (push_ns.norm() / solid_.mass_kg - kick_mps.norm()) /
                               (1.0 + (scratch_.points.empty() ? 0.0 : scratch_.points[hardest].restitution));
    if (strength_kpa <= 0.0 || stopped_mps <= law_.plastic_mps) {
        return;
    }
    const Vector3d across = along.cross(push_ns).normalized();
    double low_m = 0.0, high_m = 0.0;
    for (const PercussionPoint& point : scratch_.points) {
        const double at_m = across.dot(point.arm_m - scratch_.points.front().arm_m);
        low_m = std::min(low_m, at_m);
        high_m = std::max(high_m, at_m);
    }
    const Scar scar =
        scar_of(law_.scar, solid_.mass_kg, solid_.diameter_m(), strength_kpa, stopped_mps, high_m - low_m);
    if (scar_.left_m <= 0.0 || scar.depth_m >= scar_.depth_m) {
        scar_ = scar;
    }
}

/// Whether some contact goes on: it does not part, and without it the block would move into the ground.
bool Block::is_pressed(const Velocities& now) const {
    const Vector3d inertia_spin = body_.rotation.momentum_in_space_nms();
    const Vector3d turns = body_.inverse_inertia(solid_) * inertia_spin.cross(now.spin_radps);
    const Vector3d gravity{0.0, 0.0, -gravity_mps2};
    for (const PercussionPoint& point : scratch_.points) {
        // The lowest point of a ball is always another one: only the centre counts.
        const Vector3d free_mps2 = solid_.is_sphere()
                                       ? gravity
                                       : Vector3d{gravity + turns.cross(point.arm_m) +
                                                  now.spin_radps.cross(now.spin_radps.cross(point.arm_m))};
        if (now.at(point.arm_m).dot(point.normal) < parting_mps && free_mps2.dot(point.normal) < 0.0) {
            return true;
        }
    }
    return false;
}

Touchdown Block::strike() {
    is_over_ground(body_);
    find_contacts(together_m);
    const Velocities before = velocities_of(body_);
    Touchdown touchdown = percuss(before, Vector3d::Zero());
    touchdown.lasts = airborne_s_ < law_.step_s || is_pressed(velocities_of(body_));
    if (!touchdown.lasts) {
        plough(scar_.left_m);  // through the scar and out of it
    }
    return touchdown;
}

/// Moves the block up or down. Its motion pays for that or gains by it, so that the energy of the block stays
/// what it is: where motion cannot pay for the whole way, the block is moved as far as it can.
void Block::lift(const Vector3d& by_m) {
    const double work_j = solid_.mass_kg * gravity_mps2 * by_m.z();
    const double kinetic_j = body_.kinetic_j(solid_);
    const double share = work_j > kinetic_j ? kinetic_j / work_j : 1.0;
    // Motion never more than doubles its energy: a block that lies still is not set going. What is left is
    // booked as lost.
    const double paid_j = std::clamp(work_j, -kinetic_j, kinetic_j);
    if (paid_j != 0.0) {
        const double factor = std::sqrt(1.0 - paid_j / kinetic_j);
        body_.velocity_mps *= factor;
        body_.rotation.momentum_nms *= factor;
    }
    ledger_.correction_j += std::min(0.0, work_j + kinetic_j);
    body_.centre_m += share * by_m;
}

void Block::find_contacts(double reach_m) {
    pose(body_);
    find_touches(scratch_.patch, scratch_.posed, reach_m, scratch_.touches);
    keep_four(scratch_.touches);
}

/// A step finds an impact only where the block is already in the ground, by up to half its way.
std::optional<Vector3d> Block::overlap_of_impact_m() const {
    const TouchPoint* deepest = deepest_touch();
    if (deepest == nullptr || deepest->gap_m >= -overlap_m) {
        return std::nullopt;
    }
    const Vector3d arm_m = deepest->point_m - body_.centre_m;
    if (-velocities_of(body_).at(arm_m).dot(deepest->normal) <= law_.plastic_mps) {
        return std::nullopt;
    }
    return -deepest->gap_m * deepest->normal;
}

const TouchPoint* Block::deepest_touch() const {
    const auto deepest =
        std::min_element(scratch_.touches.begin(), scratch_.touches.end(),
                         [](const TouchPoint& a, const TouchPoint& b) { return a.gap_m < b.gap_m; });
    return deepest == scratch_.touches.end() ? nullptr : &*deepest;
}

void Block::clear_overlap() {
    constexpr int most = 8;
    for (int i = 0; i < most && is_over_ground(body_); ++i) {
        pose(body_);
        find_touches(scratch_.patch, scratch_.posed, 0.0, scratch_.touches);
        const TouchPoint* deepest = deepest_touch();
        if (deepest == nullptr || deepest->gap_m >= -together_m) {
            return;
        }
        lift(-deepest->gap_m * deepest->normal);
    }
}

/// Keeps the block at the ground: takes out a share of the overlap along the deepest contact, or the whole of
/// the gap while it is pressed. Gaps grow where a block turns about an edge, as its centre moves straight
/// within a step. Left alone, the contact would be lost and found again, and the slip decay in between, the
/// more the longer the step.
void Block::keep_at_ground() {
    const TouchPoint* deepest = deepest_touch();
    if (deepest == nullptr) {
        return;
    }
    if (deepest->gap_m < -overlap_m) {
        lift(taken_out * (-deepest->gap_m - overlap_m) * deepest->normal);
    } else if (deepest->gap_m > 0.0 && solver_.normal_sum_ns() > 0.0) {
        lift(-deepest->gap_m * deepest->normal);
    }
}

void Block::slow_down(double factor) {
    ledger_.drag_j += 0.5 * solid_.mass_kg * body_.velocity_mps.squaredNorm() * (1.0 - factor * factor);
    body_.velocity_mps *= factor;
}

/// Drag of the soil that goes with v^2 takes the same share of the speed from each metre.
void Block::plough(double way_m) {
    const double ploughed_m = std::min(way_m, scar_.left_m);
    if (ploughed_m > 0.0) {
        slow_down(config::exp_of(-scar_.drag_pm * ploughed_m));
        scar_.left_m -= ploughed_m;
    }
}

/// v <- v exp(-nu t), and the scar that lasts.
void Block::drag_in_contact(double duration_s) {
    plough(duration_s * body_.velocity_mps.norm());
    if (drag_ps_ > 0.0) {
        slow_down(config::exp_of(-drag_ps_ * duration_s));
    }
}

Touchdown Block::step(double duration_s, bool& inside) {
    const double half_s = 0.5 * duration_s;
    const auto drift = [&] {
        turning_.begin(body_.rotation);
        body_.rotation = turning_.at(half_s);
        body_.centre_m += half_s * body_.velocity_mps;
    };
    const auto drift_to_contacts = [&] {
        drift();
        inside = is_over_ground(body_);
        if (inside) {
            find_contacts(lasting_reach_m(duration_s));
        }
    };
    const Body begin = body_;
    drift_to_contacts();
    if (const auto by_m = inside ? overlap_of_impact_m() : std::nullopt) {
        // Lifted by that beforehand, it meets the ground at its surface, and has the motion to pay for it.
        body_ = begin;
        lift(*by_m);
        drift_to_contacts();
    }
    if (!inside) {
        return {};
    }
    const Vector3d kick_mps{0.0, 0.0, -gravity_mps2 * duration_s};
    Touchdown touchdown;
    if (scratch_.touches.empty()) {
        body_.velocity_mps += kick_mps;
        solver_.forget();
        scratch_.points.clear();
    } else {
        // The percussion acts in the middle of the step, so with the slip that there is by then.
        const double slip_m = slip_m_;
        slip_m_ += half_s * body_.velocity_mps.norm();
        touchdown = percuss(velocities_of(body_), kick_mps);
        if (solver_.normal_sum_ns() > 0.0) {
            slip_m_ += half_s * body_.velocity_mps.norm();
        } else {
            slip_m_ = slip_without_contact_m(slip_m, beta_ps_, duration_s);
        }
        touchdown.lasts = is_pressed(velocities_of(body_));
    }
    if (!touchdown.touched) {
        slip_m_ = slip_without_contact_m(slip_m_, beta_ps_, duration_s);
    }
    drift();
    if (touchdown.touched) {
        // After the drift, whose way belongs to the velocity that gravity's kick left.
        drag_in_contact(duration_s);
        keep_at_ground();
    }
    return touchdown;
}

void Block::meet_obstacle(const Vector3d& velocity_mps, double spin_factor) {
    const double before_j = body_.kinetic_j(solid_);
    body_.velocity_mps = velocity_mps;
    body_.rotation.momentum_nms *= spin_factor;
    ledger_.obstacles_j += before_j - body_.kinetic_j(solid_);
}

void Block::come_to_rest(double& booked_j) {
    booked_j += body_.kinetic_j(solid_);
    body_.velocity_mps.setZero();
    body_.rotation.momentum_nms.setZero();
}

double Block::gap_m(double reach_m) {
    if (!is_over_ground(body_)) {
        return reach_m;
    }
    pose(body_);
    find_touches(scratch_.patch, scratch_.posed, reach_m, scratch_.touches);
    double gap_m = reach_m;
    for (const TouchPoint& touch : scratch_.touches) {
        gap_m = std::min(gap_m, touch.gap_m);
    }
    return gap_m;
}

void Block::move_by(const Vector3d& by_m) {
    const double before_j = body_.potential_j(solid_);
    body_.centre_m += by_m;
    ledger_.start_j += body_.potential_j(solid_) - before_j;
}

}  // namespace rockfall::rigid
