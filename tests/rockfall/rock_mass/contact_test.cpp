// Friction at contacts: along them and about their normal.

#include "rockfall/rock_mass/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using namespace scenes;

constexpr double gravity_mps2 = 9.81;
constexpr double density_kgpm3 = 2500.0;

double radians(double deg) {
    return deg * std::numbers::pi / 180.0;
}

constexpr double stiff_pa = 1e9;
constexpr double study_pa = 1e8;  ///< E* of the PFC3D study

Laws laws_of_friction(double friction, double modulus_pa = stiff_pa) {
    Laws laws;
    laws.modulus_pa = modulus_pa;
    laws.friction = laws.ground_friction = friction;
    laws.sleeping = false;
    return laws;
}

/// Slabs of 4 x 4 x 1 m on each other, on a plane that falls towards -x.
std::vector<BlockStart> pile_of_slabs(int count, double dip_rad) {
    const Eigen::Quaterniond turn{Eigen::AngleAxisd{-dip_rad, Vector3d::UnitY()}};
    std::vector<BlockStart> slabs;
    for (int k = 0; k < count; ++k) {
        slabs.push_back(
            block_of(solids::placed(solids::box({4.0, 4.0, 1.0}), turn, turn * Vector3d{0.0, 0.0, k + 0.5}),
                     density_kgpm3, false));
    }
    return slabs;
}

void run_for(RockMass& mass, double time_s) {
    mass.advance(static_cast<std::uint64_t>(time_s / mass.step_s()));
}

/// A mass that was held until its weight rests on its contacts.
RockMass held_before(const Laws& laws, const std::vector<BlockStart>& blocks, double dip_rad) {
    RockMass mass{laws, blocks, {}, Ground{plane_of(std::tan(dip_rad))}};
    mass.hold();
    run_for(mass, 2.0);
    mass.let_go();
    return mass;
}

void expect_pile_holds(int count, double dip_deg, double modulus_pa) {
    const double dip_rad = radians(dip_deg);
    RockMass mass = held_before(laws_of_friction(0.3, modulus_pa), pile_of_slabs(count, dip_rad), dip_rad);
    const std::vector<Block> before{mass.blocks().begin(), mass.blocks().end()};
    run_for(mass, 60.0);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Block& slab = mass.blocks()[i];
        EXPECT_LT((slab.centre_m - before[i].centre_m).norm(), 1e-3) << count << " on " << dip_deg;
        EXPECT_LT(slab.rotation.attitude.angularDistance(before[i].rotation.attitude), 1e-3);
        EXPECT_LT(slab.spin_radps().norm(), 1e-6) << count << " on " << dip_deg;
    }
}

TEST(Friction, HoldsPilesOfSlabsOnSlopes) {
    for (const double modulus_pa : {study_pa, stiff_pa}) {
        for (const double dip_deg : {5.0, 10.0, 15.0}) {
            for (const int count : {1, 2, 3}) {
                expect_pile_holds(count, dip_deg, modulus_pa);
            }
        }
    }
}

TEST(Friction, LetsPilesOfSlabsSleep) {
    const double dip_rad = radians(15.0);
    Laws laws = laws_of_friction(0.3);
    laws.sleeping = true;
    RockMass mass{laws, pile_of_slabs(3, dip_rad), {}, Ground{plane_of(std::tan(dip_rad))}};
    run_for(mass, 5.0);
    for (const Block& slab : mass.blocks()) {
        EXPECT_EQ(slab.status, BlockStatus::asleep);
    }
}

TEST(Friction, LetsASlabSlideByWhatItCannotHold) {
    for (const auto& [dip_deg, friction, modulus_pa] : {std::tuple{25.0, 0.3, stiff_pa},
                                                        {25.0, 0.3, study_pa},
                                                        {17.5, 0.3, study_pa},
                                                        {15.0, 0.2, stiff_pa}}) {
        const double dip_rad = radians(dip_deg);
        RockMass mass =
            held_before(laws_of_friction(friction, modulus_pa), pile_of_slabs(1, dip_rad), dip_rad);
        const Vector3d from_m = mass.blocks()[0].centre_m;
        while (mass.time_s() < 6.0) {
            mass.step();
        }
        const double way_m = 0.5 * gravity_mps2 * (std::sin(dip_rad) - friction * std::cos(dip_rad)) *
                             mass.time_s() * mass.time_s();
        EXPECT_NEAR((mass.blocks()[0].centre_m - from_m).norm(), way_m, 0.003 * way_m) << dip_deg;
        EXPECT_LT(std::abs(residual_share(mass)), 1e-3);
    }
}

/// A prism of 1 m height with its axis upright, on level ground.
struct Spinner {
    solids::Hull hull;
    double friction_radius_m;  ///< mean distance of its base from the middle
};

/// A regular prism of 24 corners: a disc but for 1 %.
Spinner disc(double radius_m) {
    std::vector<Vector3d> corners_m;
    for (int k = 0; k < 24; ++k) {
        const double angle = k * std::numbers::pi / 12.0;
        for (const double z_m : {-0.5, 0.5}) {
            corners_m.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle), z_m);
        }
    }
    return {solids::convex_hull(corners_m), 2.0 / 3.0 * radius_m};
}

/// Sides a along x and b along y; integral of r over a quarter of it by its area.
Spinner box(double a_m, double b_m) {
    const double p = 0.5 * a_m, q = 0.5 * b_m;
    const double integral_m3 =
        (2.0 * p * q * std::hypot(p, q) + p * p * p * std::asinh(q / p) + q * q * q * std::asinh(p / q)) /
        6.0;
    return {solids::box({a_m, b_m, 1.0}), integral_m3 / (p * q)};
}

BlockStart on_level_ground(const Spinner& spinner, const Laws& laws) {
    BlockStart start = block_of(spinner.hull, density_kgpm3, false);
    // Pressed in as deep as its weight holds it: c = E* / 2 r.
    const double press_m = density_kgpm3 * gravity_mps2 * std::cbrt(start.solid.volume_m3) / laws.modulus_pa;
    start.centre_m.z() += 0.5 - press_m;
    return start;
}

TEST(Friction, StopsASpinAfterTheAngleOfItsMoment) {
    constexpr double friction = 0.4, spin_radps = 3.0;
    for (const Spinner& spinner : {disc(2.0), box(4.0, 4.0), box(6.0, 2.0)}) {
        const Laws laws = laws_of_friction(friction);
        BlockStart start = on_level_ground(spinner, laws);
        start.momentum_nms = start.solid.inertia_kgm2.cwiseProduct(start.attitude.conjugate() *
                                                                   Vector3d{0.0, 0.0, spin_radps});
        RockMass mass{laws, {&start, 1}, {}, Ground{plane_of(0.0)}};
        double turned = 0.0, stop_s = 0.0;
        while (mass.time_s() < 3.0) {
            mass.step();
            const double now_radps = mass.blocks()[0].spin_radps().z();
            turned += now_radps * mass.step_s();
            stop_s = now_radps > 1e-3 * spin_radps ? mass.time_s() : stop_s;
        }
        const Vector3d axis = start.attitude.conjugate() * Vector3d::UnitZ();
        const double inertia_kgm2 = axis.dot(start.solid.inertia_kgm2.cwiseProduct(axis));
        const double moment_nm = friction * start.solid.mass_kg * gravity_mps2 * spinner.friction_radius_m;
        const double angle = 0.5 * inertia_kgm2 * spin_radps * spin_radps / moment_nm;
        const double time_s = inertia_kgm2 * spin_radps / moment_nm;
        EXPECT_NEAR(turned, angle, 0.015 * angle) << spinner.friction_radius_m;
        EXPECT_NEAR(stop_s, time_s, 0.015 * time_s) << spinner.friction_radius_m;
        EXPECT_NEAR(mass.ledger().friction_j, mass.motion_at_start_j(), 1e-3 * mass.motion_at_start_j());
        EXPECT_LT(std::abs(residual_share(mass)), 1e-3);
    }
}

TEST(Friction, EndsSlidingAndSpinTogether) {
    // Farkas et al. 2003 (Phys. Rev. Lett. 90:248302): however a disc starts, both end at the same time.
    for (const auto& [speed_mps, spin_radps] : {std::pair{1.0, 0.2}, {0.5, 0.5}, {0.2, 1.0}}) {
        const Laws laws = laws_of_friction(0.1);
        BlockStart start = on_level_ground(disc(2.0), laws);
        start.velocity_mps.x() = speed_mps;
        start.momentum_nms = start.solid.inertia_kgm2.cwiseProduct(start.attitude.conjugate() *
                                                                   Vector3d{0.0, 0.0, spin_radps});
        RockMass mass{laws, {&start, 1}, {}, Ground{plane_of(0.0)}};
        double slides_until_s = 0.0, spins_until_s = 0.0;
        while (mass.time_s() < 2.0) {
            mass.step();
            const Block& block = mass.blocks()[0];
            slides_until_s = block.velocity_mps.x() > 0.01 * speed_mps ? mass.time_s() : slides_until_s;
            spins_until_s = block.spin_radps().z() > 0.01 * spin_radps ? mass.time_s() : spins_until_s;
        }
        EXPECT_NEAR(slides_until_s, spins_until_s, 0.05 * spins_until_s) << speed_mps << " m/s";
        // Each takes from the other: later than by sliding alone.
        EXPECT_GT(slides_until_s, 1.01 * speed_mps / (0.1 * gravity_mps2)) << speed_mps << " m/s";
        EXPECT_LT(std::abs(residual_share(mass)), 1e-3);
    }
}

TEST(Friction, BooksAPileThatSlidesAndTurnsApart) {
    // Three slabs, each with a spin of its own, on a slope that is too steep for them.
    const double dip_rad = radians(25.0);
    for (const double damping : {0.0, 0.5}) {
        std::vector<BlockStart> slabs = pile_of_slabs(3, dip_rad);
        for (std::size_t k = 0; k < slabs.size(); ++k) {
            const Vector3d spin_radps =
                slabs[k].attitude.conjugate() *
                (Eigen::AngleAxisd{-dip_rad, Vector3d::UnitY()} * Vector3d{0.0, 0.0, k == 1 ? -2.0 : 1.0});
            slabs[k].momentum_nms = slabs[k].solid.inertia_kgm2.cwiseProduct(spin_radps);
        }
        Laws laws = laws_of_friction(0.3);
        laws.modulus_pa = 1e8;
        laws.damping_ratio = damping;
        RockMass mass{laws, slabs, {}, Ground{plane_of(std::tan(dip_rad))}};
        double friction_j = 0.0;
        while (mass.time_s() < 4.0) {
            run_for(mass, 0.1);
            const Ledger ledger = mass.ledger();
            EXPECT_GE(ledger.friction_j, friction_j);
            friction_j = ledger.friction_j;
            EXPECT_LT(std::abs(residual_share(mass)), 0.02) << damping << ", " << mass.time_s() << " s";
        }
        EXPECT_GT(friction_j, 0.0);
    }
}

TEST(Friction, UnderTheLawOfPfcHoldsNoSpin) {
    Laws laws = laws_of_friction(0.4);
    laws.contact = ContactLaw::pfc;
    BlockStart start = on_level_ground(box(4.0, 4.0), laws);
    start.momentum_nms =
        start.solid.inertia_kgm2.cwiseProduct(start.attitude.conjugate() * Vector3d::UnitZ());
    RockMass mass{laws, {&start, 1}, {}, Ground{plane_of(0.0)}};
    run_for(mass, 2.0);
    EXPECT_NEAR(mass.blocks()[0].spin_radps().z(), 1.0, 0.02);
}

}  // namespace
}  // namespace rockfall::rock_mass
