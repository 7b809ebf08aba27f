#include "rockfall/rock_mass/bond.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/rock_mass/rock_mass.hpp"
#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using Eigen::Vector3d;

/// A square of 2 m by 2 m across z.
const std::vector<Vector3d> square{{1.0, 1.0, 5.0}, {-1.0, 1.0, 5.0}, {-1.0, -1.0, 5.0}, {1.0, -1.0, 5.0}};

TEST(BondSection, OfARectangleHasItsMoments) {
    // 4 m by 2 m, turned in its plane: I = b h^3 / 12.
    const Eigen::Quaterniond turn{Eigen::AngleAxisd{0.7, Vector3d{1.0, 2.0, 3.0}.normalized()}};
    std::vector<Vector3d> corners;
    for (const auto& [x, y] : {std::pair{2.0, 1.0}, {-2.0, 1.0}, {-2.0, -1.0}, {2.0, -1.0}}) {
        corners.push_back(turn * Vector3d{x, y, 0.0} + Vector3d{7.0, 8.0, 9.0});
    }
    const PlacedSection placed = section_of(corners, turn * Vector3d::UnitZ());
    EXPECT_NEAR(placed.section.area_m2, 8.0, 1e-12);
    EXPECT_NEAR(placed.section.about_second_m4, 4.0 * 8.0 / 12.0, 1e-12);
    EXPECT_NEAR(placed.section.about_first_m4, 2.0 * 64.0 / 12.0, 1e-12);
    EXPECT_NEAR((placed.middle_m - Vector3d(7.0, 8.0, 9.0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(placed.section.reach_m, std::sqrt(5.0), 1e-12);
    EXPECT_NEAR((placed.axes * Vector3d::UnitZ() - turn * Vector3d::UnitZ()).norm(), 0.0, 1e-12);
}

/// Section, stiffness and strength of a bond for loads along one line of strain.
struct Loaded {
    PlacedSection placed = section_of(square, Vector3d::UnitZ());
    BondStiffness stiffness{5e7, 2e7};
    BondStrength strength{3e6, 2e6};

    /// The strain at which the bond breaks when it grows along `direction`, by bisection to the last bits.
    [[nodiscard]] BondStrain at_failure(const BondStrain& direction) const {
        double low = 0.0, high = 1.0;
        for (int i = 0; i < 200; ++i) {
            const double middle = 0.5 * (low + high);
            (breaks(bond_stress(placed.section, stiffness, times(direction, middle)), strength, 0.0) ? high
                                                                                                     : low) =
                middle;
        }
        return times(direction, high);
    }
    static BondStrain times(const BondStrain& strain, double factor) {
        return {factor * strain.shift_m, factor * strain.turn};
    }
    [[nodiscard]] BondLoad load(const BondStrain& strain) const {
        return bond_load(placed.section, stiffness, strain);
    }
    [[nodiscard]] double energy_j(const BondStrain& strain) const {
        return bond_energy(placed.section, stiffness, strain).sum_j();
    }
};

TEST(Bond, PulledBreaksAtItsTensileStrength) {
    const Loaded bond;
    const BondStrain strain = bond.at_failure({{0.0, 0.0, 1.0}, Vector3d::Zero()});
    EXPECT_NEAR(bond.load(strain).force_n.z(), 3e6 * 4.0, 1e-9 * 3e6 * 4.0);
    EXPECT_NEAR(bond.energy_j(strain), 0.5 * 3e6 * 3e6 / 5e7 * 4.0, 1e-9 * 1e6);
}

TEST(Bond, ShearedBreaksAtItsShearStrength) {
    const Loaded bond;
    const BondStrain strain = bond.at_failure({{0.6, 0.8, 0.0}, Vector3d::Zero()});
    EXPECT_NEAR(bond.load(strain).force_n.norm(), 2e6 * 4.0, 1e-9 * 2e6 * 4.0);
    EXPECT_NEAR(bond.energy_j(strain), 0.5 * 2e6 * 2e6 / 2e7 * 4.0, 1e-9 * 1e6);
}

TEST(Bond, BentBreaksWhereItsRimReachesTheTensileStrength) {
    const Loaded bond;
    const BondStrain strain = bond.at_failure({Vector3d::Zero(), {1.0, 0.0, 0.0}});
    const double moment_nm = 3e6 * (16.0 / 12.0) / 1.0;  // sigma I / R
    EXPECT_NEAR(bond.load(strain).moment_nm.norm(), moment_nm, 1e-9 * moment_nm);
    EXPECT_NEAR(bond.energy_j(strain), 0.5 * moment_nm * moment_nm / (5e7 * 16.0 / 12.0), 1.0e-3);
}

TEST(Bond, TwistedBreaksWhereItsRimReachesTheShearStrength) {
    const Loaded bond;
    const BondStrain strain = bond.at_failure({Vector3d::Zero(), {0.0, 0.0, 1.0}});
    const double moment_nm = 2e6 * (32.0 / 12.0) / std::sqrt(2.0);  // tau J / R
    EXPECT_NEAR(bond.load(strain).moment_nm.z(), moment_nm, 1e-9 * moment_nm);
}

TEST(Bond, PressureAddsToItsShearStrength) {
    const Loaded bond;
    const BondStress stress =
        bond_stress(bond.placed.section, bond.stiffness, {{0.11, 0.0, -0.04}, Vector3d::Zero()});
    EXPECT_DOUBLE_EQ(stress.pressure_pa, 2e6);
    EXPECT_TRUE(breaks(stress, bond.strength, 0.0));
    EXPECT_FALSE(breaks(stress, bond.strength, 0.2));
}

TEST(Bond, ForceIsTheGradientOfItsEnergy) {
    const Loaded loaded;
    const auto a = scenes::cube_at({0.0, 0.0, 4.0}, 2.0), b = scenes::cube_at({0.0, 0.0, 6.0}, 2.0);
    Bond bond;
    bond.section = loaded.placed.section;
    bond.section.about_first_m4 *= 3.0;  // unlike about the two axes
    bond.stiffness = loaded.stiffness;
    bond.anchor_in_first_m = loaded.placed.middle_m - a.centre_m;
    bond.anchor_in_second_m = loaded.placed.middle_m - b.centre_m;
    bond.axes_in_first = bond.axes_in_second = loaded.placed.axes;
    const auto turned = [](const Vector3d& by) {
        return Eigen::Quaterniond{Eigen::AngleAxisd{by.norm(), by.stableNormalized()}};
    };
    const BlockPose first{a.centre_m, turned({0.1, -0.2, 0.05})};
    const BlockPose second{b.centre_m + Vector3d{0.1, 0.2, -0.1}, turned({-0.1, 0.3, 0.2})};
    const auto energy_j = [&](const BlockPose& p, const BlockPose& q) {
        return bond_energy(bond.section, bond.stiffness, strain_of(bond, p, q).strain).sum_j();
    };
    const PairForce force =
        bond_force(bond, strain_of(bond, first, second), {first.centre_m}, {second.centre_m});
    const double h = 1e-5, scale = 1e-7 * energy_j(first, second) / 1e-2;
    for (int k = 0; k < 3; ++k) {
        const Vector3d e = h * Vector3d::Unit(k);
        const auto moved = [](const BlockPose& pose, const Vector3d& by) {
            return BlockPose{pose.centre_m + by, pose.attitude};
        };
        const auto spun = [&](const BlockPose& pose, const Vector3d& by) {
            return BlockPose{pose.centre_m, turned(by) * pose.attitude};
        };
        EXPECT_NEAR(force.force_n[k],
                    -(energy_j(first, moved(second, e)) - energy_j(first, moved(second, -e))) / (2.0 * h),
                    scale);
        EXPECT_NEAR(-force.force_n[k],
                    -(energy_j(moved(first, e), second) - energy_j(moved(first, -e), second)) / (2.0 * h),
                    scale);
        EXPECT_NEAR(force.moment_on_second_nm[k],
                    -(energy_j(first, spun(second, e)) - energy_j(first, spun(second, -e))) / (2.0 * h),
                    scale);
        EXPECT_NEAR(force.moment_on_first_nm[k],
                    -(energy_j(spun(first, e), second) - energy_j(spun(first, -e), second)) / (2.0 * h),
                    scale);
    }
}

TEST(Bond, FreesWhatItHeldWhenItIsPulledApart) {
    using namespace scenes;
    std::vector<BlockStart> blocks{cube_at(Vector3d::Zero(), 1.0), cube_at({1.0, 0.0, 0.0}, 1.0)};
    blocks[1].velocity_mps.x() = 8.0;
    const BondStart bond = bond_between(0, 1, Vector3d::Zero(), {1.0, 0.0, 0.0}, 1.0, {2e6, 1e9});
    Laws laws = lossless();
    laws.step_factor = 0.0005;
    RockMass mass{laws, blocks, {&bond, 1}, Ground{}};
    while (mass.bonds_intact() == 1 && mass.time_s() < 1.0) {
        mass.step();
    }
    EXPECT_EQ(mass.broken_by_tension(), 1U);
    const double held_j = 0.5 * 2e6 * 2e6 / 1e8;  // sigma^2 A / 2 k_n
    EXPECT_NEAR(mass.ledger().fracture_j, held_j, 2e-3 * held_j);
    EXPECT_NEAR(mass.ledger().residual_j(), 0.0, 1e-3 * held_j);
}

constexpr double cube_weight_n = 2500.0 * 9.81;

/// Whether the bond breaks by which a cube of a metre is held at a fixed one: once it carries the weight of
/// the cube at rest, or when it gets that suddenly.
bool breaks_under_the_weight(const Vector3d& cube_m, const BondStrength& strength, bool at_rest) {
    using namespace scenes;
    const std::vector<BlockStart> blocks{cube_at(Vector3d::Zero(), 1.0, 2500.0, true), cube_at(cube_m, 1.0)};
    const BondStart bond = bond_between(0, 1, Vector3d::Zero(), cube_m, 1.0, strength);
    Laws laws = lossless();
    laws.gravity_mps2 = 9.81;
    laws.modulus_pa = 1e9;
    laws.step_factor = at_rest ? 0.2 : 0.005;
    RockMass mass{laws, blocks, {&bond, 1}, Ground{}};
    if (at_rest) {
        mass.hold();
        mass.advance(4000);
        mass.let_go();
    }
    mass.advance(at_rest ? 20 : 2000);  // 2000 are more than a period
    return mass.bonds_intact() == 0;
}

void expect_stress_under_the_weight(const Vector3d& cube_m, double tension_pa, double shear_pa,
                                    bool at_rest) {
    constexpr double any_pa = 1e99, part = 1e-6;
    if (tension_pa > 0.0) {
        EXPECT_TRUE(breaks_under_the_weight(cube_m, {(1.0 - part) * tension_pa, any_pa}, at_rest));
        EXPECT_FALSE(breaks_under_the_weight(cube_m, {(1.0 + part) * tension_pa, any_pa}, at_rest));
    }
    if (shear_pa > 0.0) {
        EXPECT_TRUE(breaks_under_the_weight(cube_m, {any_pa, (1.0 - part) * shear_pa}, at_rest));
        EXPECT_FALSE(breaks_under_the_weight(cube_m, {any_pa, (1.0 + part) * shear_pa}, at_rest));
    }
}

TEST(Bond, OfACubeThatHangsBearsItsWeightToAMillionth) {
    expect_stress_under_the_weight({0.0, 0.0, -1.0}, cube_weight_n, 0.0, true);
}

TEST(Bond, OfACubeAtTheSideBearsShearAndBendingToAMillionth) {
    // Its weight acts half a metre from the face, which has I / R = 1 / 6 m3.
    expect_stress_under_the_weight({1.0, 0.0, 0.0}, 3.0 * cube_weight_n, cube_weight_n, true);
}

TEST(Bond, OfACubeThatIsLetGoBearsTwiceItsWeightToAMillionth) {
    expect_stress_under_the_weight({0.0, 0.0, -1.0}, 2.0 * cube_weight_n, 0.0, false);
}

}  // namespace
}  // namespace rockfall::rock_mass
