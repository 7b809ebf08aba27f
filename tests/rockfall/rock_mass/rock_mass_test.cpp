#include "rockfall/rock_mass/rock_mass.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/rock_mass/voronoi_cells.hpp"
#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using namespace scenes;

/// Cubes of 1 m in a row along x, joined; the first one fixed.
struct Beam {
    std::vector<BlockStart> blocks;
    std::vector<BondStart> bonds;
    explicit Beam(std::uint32_t cubes, bool fixed, BondStrength strength = {1e99, 1e99}) {
        for (std::uint32_t i = 0; i < cubes; ++i) {
            blocks.push_back(cube_at({i + 0.0, 0.0, 0.0}, 1.0, 2500.0, fixed && i == 0));
            if (i > 0) {
                bonds.push_back(
                    bond_between(i - 1, i, {i - 1.0, 0.0, 0.0}, {i + 0.0, 0.0, 0.0}, 1.0, strength));
            }
        }
    }
};

TEST(RockMass, CantileverBendsAsABeam) {
    // Ten joints of a metre between the middles of eleven cubes: the weight of each cube acts at its middle.
    constexpr std::uint32_t joints = 10;
    Beam beam{joints + 1, true};
    Laws laws = lossless();
    laws.modulus_pa = 1e9;
    laws.gravity_mps2 = 0.01;
    laws.local_damping = 0.4;
    RockMass mass{laws, beam.blocks, beam.bonds, Ground{}};
    mass.advance(30000);

    const double weight_n = 2500.0 * laws.gravity_mps2;
    const double bending = laws.modulus_pa / 12.0;                   // E I
    const double shearing = laws.modulus_pa / laws.stiffness_ratio;  // G A
    double deflection_m = 0.0, rotation = 0.0;
    for (std::uint32_t load = 1; load <= joints; ++load) {
        const double at = load;  // Timoshenko beam under a point load, deflection and rotation of its end
        deflection_m += weight_n * (at * at * (3.0 * joints - at) / (6.0 * bending) + at / shearing);
        rotation += weight_n * at * at / (2.0 * bending);
    }
    EXPECT_NEAR(-mass.blocks()[joints].centre_m.z(), deflection_m, 0.01 * deflection_m);
    const Eigen::Vector3d axis = mass.blocks()[joints].rotation.attitude * Vector3d::UnitX();
    EXPECT_NEAR(std::asin(-axis.z()), rotation, 0.01 * rotation);
}

TEST(RockMass, CantileverBreaksAtItsRoot) {
    Beam beam{6, true, {1e5, 1e9}};
    Laws laws = lossless();
    laws.modulus_pa = 1e9;
    laws.gravity_mps2 = 9.81;  // at the root 5 cubes bend with 2.5 t g x 12.5 m, 1.8 MPa at its edge
    RockMass mass{laws, beam.blocks, beam.bonds, Ground{}};
    while (mass.bonds_intact() == 5 && mass.time_s() < 2.0) {
        mass.step();
    }
    EXPECT_EQ(mass.bonds_intact(), 4U);
    mass.advance(static_cast<std::uint64_t>(0.5 / mass.step_s()));
    EXPECT_LT(mass.blocks()[1].centre_m.z(), -0.5);  // the root bond it was
}

TEST(RockMass, WaveRunsThroughABarWithTheSpeedOfItsMaterial) {
    constexpr std::uint32_t cubes = 140;
    Beam beam{cubes, false};
    Laws laws = lossless();
    laws.modulus_pa = 1e9;
    laws.step_factor = 0.1;
    // A smooth push, 1 - cos: half of it runs to either side.
    for (std::uint32_t i = 0; i < 20; ++i) {
        beam.blocks[20 + i].velocity_mps.x() =
            0.01 * (1.0 - std::cos(2.0 * 3.14159265358979 * (i + 0.5) / 20.0));
    }
    RockMass mass{laws, beam.blocks, beam.bonds, Ground{}};
    const auto middle_of_motion_m = [&] {
        double sum = 0.0, weight = 0.0;
        for (std::uint32_t i = 60; i < cubes; ++i) {
            const double v = mass.blocks()[i].velocity_mps.x();
            sum += v * i;
            weight += v;
        }
        return sum / weight;
    };
    const double speed_mps = std::sqrt(1e9 / 2500.0);
    const auto until = [&](double time_s) {
        while (mass.time_s() < time_s) {
            mass.step();
        }
    };
    until(50.0 / speed_mps);
    const double first_s = mass.time_s(), first_m = middle_of_motion_m();
    until(70.0 / speed_mps);
    EXPECT_NEAR((middle_of_motion_m() - first_m) / (mass.time_s() - first_s), speed_mps, 0.02 * speed_mps);
}

TEST(RockMass, CradleOfFiveHandsItsSpeedOn) {
    std::vector<BlockStart> blocks;
    for (int i = 0; i < 5; ++i) {
        blocks.push_back(cube_at({1.5 * i, 0.0, 0.0}, 1.0));
    }
    blocks[0].velocity_mps = {1.0, 0.0, 0.0};
    Laws laws = lossless();
    laws.step_factor = 0.05;
    RockMass mass{laws, blocks, {}, Ground{}};
    while (mass.time_s() < 3.0) {
        mass.step();
    }
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(mass.blocks()[i].velocity_mps.norm(), 0.0, 1e-3) << i;
    }
    EXPECT_NEAR(mass.blocks()[4].velocity_mps.x(), 1.0, 1e-3);
}

TEST(RockMass, BilliardPairPartsAtARightAngleAndKeepsEverything) {
    // Smooth cubes: the motion across the common face is exchanged, that along it stays.
    std::vector<BlockStart> blocks{cube_at({-1.2, -0.2, 0.0}, 1.0), cube_at({0.0, 0.0, 0.0}, 1.0)};
    blocks[0].velocity_mps = {1.0, 1.0, 0.0};
    Laws laws = lossless();
    laws.modulus_pa = 1e10;
    laws.step_factor = 0.02;
    RockMass mass{laws, blocks, {}, Ground{}};
    const double before_j = mass.ledger().held_j();
    while (mass.time_s() < 0.5) {
        mass.step();
    }
    const Vector3d v1 = mass.blocks()[0].velocity_mps, v2 = mass.blocks()[1].velocity_mps;
    EXPECT_NEAR(mass.ledger().held_j(), before_j, 1e-3 * before_j);
    EXPECT_LT((v1 + v2 - Vector3d(1.0, 1.0, 0.0)).norm(), 1e-12);
    EXPECT_NEAR(v1.dot(v2) / (v1.norm() * v2.norm()), 0.0, 0.01);
    EXPECT_NEAR(v2.x(), 1.0, 0.01);
}

/// A cube of 1 m on a plane, lying on it with one face.
BlockStart cube_on_plane(double dip_rad, double press_m) {
    // The plane rises with x: the block is turned about -y.
    const Eigen::Quaterniond turn{Eigen::AngleAxisd{-dip_rad, Vector3d::UnitY()}};
    const Vector3d normal{-std::sin(dip_rad), 0.0, std::cos(dip_rad)};
    return block_of(solids::placed(solids::box(Vector3d::Ones()), turn, (0.5 - press_m) * normal), 2500.0,
                    false);
}

Laws laws_of_slope(double friction) {
    Laws laws;
    laws.modulus_pa = 1e9;
    laws.ground_friction = friction;
    laws.sleeping = false;
    laws.step_factor = 0.1;
    return laws;
}

TEST(RockMass, CubeSlidesDownAPlane) {
    const double dip_rad = 38.0 * 3.14159265358979323846 / 180.0;
    const Laws laws = laws_of_slope(0.35);
    // Pressed in as deep as its weight holds it.
    const double press_m = 2500.0 * 9.81 * std::cos(dip_rad) / laws.modulus_pa;
    const BlockStart cube = cube_on_plane(dip_rad, press_m);
    RockMass mass{laws, {&cube, 1}, {}, Ground{plane_of(std::tan(dip_rad))}};
    while (mass.time_s() < 5.0) {
        mass.step();
    }
    const double way_m =
        0.5 * 9.81 * (std::sin(dip_rad) - 0.35 * std::cos(dip_rad)) * mass.time_s() * mass.time_s();
    EXPECT_NEAR((mass.blocks()[0].centre_m - cube.centre_m).norm(), way_m, 0.005 * way_m);
    EXPECT_LT(std::abs(residual_share(mass)), 1e-3);
}

TEST(RockMass, CubeSticksOnAPlane) {
    const double dip_rad = 38.0 * 3.14159265358979323846 / 180.0;
    Laws laws = laws_of_slope(0.85);
    laws.modulus_pa = 1e10;
    const BlockStart cube = cube_on_plane(dip_rad, 2500.0 * 9.81 * std::cos(dip_rad) / laws.modulus_pa);
    RockMass mass{laws, {&cube, 1}, {}, Ground{plane_of(std::tan(dip_rad))}};
    mass.advance(static_cast<std::uint64_t>(60.0 / mass.step_s()));
    EXPECT_LT((mass.blocks()[0].centre_m - cube.centre_m).norm(), 1e-3);
}

TEST(RockMass, ColumnTipsWhereItsWeightLinePassesItsFoot) {
    // Twice as high as wide: it tips where tan(dip) > 1/2 and friction holds it.
    for (const double dip_deg : {26.44, 26.69}) {
        const double dip_rad = dip_deg * 3.14159265358979323846 / 180.0;
        Laws laws = laws_of_slope(0.9);
        laws.modulus_pa = 4e12;  // soft feet tip earlier
        const Eigen::Quaterniond turn{Eigen::AngleAxisd{-dip_rad, Vector3d::UnitY()}};
        const Vector3d normal{-std::sin(dip_rad), 0.0, std::cos(dip_rad)};
        const BlockStart column = block_of(
            solids::placed(solids::box({1.0, 1.0, 2.0}), turn, (1.0 - 5000.0 * 9.81 / 4e12) * normal), 2500.0,
            false);
        RockMass mass{laws, {&column, 1}, {}, Ground{plane_of(std::tan(dip_rad))}};
        mass.advance(static_cast<std::uint64_t>(2.0 / mass.step_s()));
        const double tilt =
            (mass.blocks()[0].rotation.attitude * column.attitude.conjugate()).vec().norm() * 2.0;
        const bool tipped = tilt > 0.1;
        EXPECT_EQ(tipped, std::tan(dip_rad) > 0.5) << dip_deg;
    }
}

TEST(RockMass, DashpotOfHalfTheCriticalOneGivesARestitutionOfThirtyPercent) {
    // e = exp(-beta / sqrt(1 - beta^2) (pi - pi / 3)) for beta 0.5, as the force never pulls.
    std::vector<BlockStart> blocks{cube_at({-1.1, 0.0, 0.0}, 1.0), cube_at({0.0, 0.0, 0.0}, 1.0)};
    blocks[0].velocity_mps = {1.0, 0.0, 0.0};
    Laws laws = lossless();
    laws.damping_ratio = 0.5;
    laws.step_factor = 0.01;
    RockMass mass{laws, blocks, {}, Ground{}};
    while (mass.time_s() < 0.5) {
        mass.step();
    }
    const double parting_mps = mass.blocks()[1].velocity_mps.x() - mass.blocks()[0].velocity_mps.x();
    EXPECT_NEAR(parting_mps, std::exp(-2.0 / 3.0 * 3.14159265358979 * 0.5 / std::sqrt(0.75)), 0.005);
    EXPECT_NEAR(mass.ledger().residual_j(), 0.0, 1e-3 * mass.motion_at_start_j());
}

TEST(RockMass, ABlockAtRestThatIsHitStartsAgain) {
    std::vector<BlockStart> blocks{cube_at({-12.0, 0.0, 0.5}, 1.0), cube_at({0.0, 0.0, 0.5}, 1.0)};
    blocks[0].velocity_mps = {12.0, 0.0, 0.0};
    Laws laws;
    RockMass mass{laws, blocks, {}, Ground{plane_of(0.0)}};
    while (mass.time_s() < 1.0) {
        mass.step();
    }
    ASSERT_EQ(mass.blocks()[1].status, BlockStatus::asleep);
    while (mass.time_s() < 10.0) {
        mass.step();
    }
    // It leaves with (1 + e) / 2 of the speed of the other one, and friction stops it.
    const double hit_m2ps2 = 144.0 - 2.0 * 0.3 * 9.81 * 11.0, share = 0.5 * (1.0 + 0.3);
    const double way_m = share * share * hit_m2ps2 / (2.0 * 0.3 * 9.81);
    EXPECT_NEAR(mass.blocks()[1].centre_m.x(), way_m, 0.1 * way_m);
    EXPECT_EQ(mass.blocks()[1].status, BlockStatus::asleep);
    EXPECT_LT(std::abs(residual_share(mass)), 0.02);
}

/// Ten cubes of 2 m far from each other and above level ground, and a plate of 0.4 m.
std::vector<BlockStart> cubes_and_a_plate() {
    std::vector<BlockStart> blocks;
    for (int k = 0; k < 10; ++k) {
        blocks.push_back(cube_at({6.0 * k, 0.0, 6.0}, 2.0));
    }
    blocks.push_back(block_of(
        solids::placed(solids::box({2.0, 2.0, 0.4}), Eigen::Quaterniond::Identity(), {-6.0, 0.0, 6.0}),
        2500.0, false));
    return blocks;
}

TEST(MassScaling, GivesTheThinnestBlockTheStepOfTheOthers) {
    const std::vector<BlockStart> blocks = cubes_and_a_plate();
    Laws laws;
    const RockMass as_it_is{laws, blocks, {}, Ground{plane_of(0.0)}};
    const RockMass of_cubes{laws, std::span{blocks}.first(10), {}, Ground{plane_of(0.0)}};
    laws.heavier_share = 0.1;
    RockMass scaled{laws, blocks, {}, Ground{plane_of(0.0)}};
    EXPECT_LT(as_it_is.step_s(), 0.8 * of_cubes.step_s());
    EXPECT_DOUBLE_EQ(scaled.step_s(), of_cubes.step_s());
    EXPECT_EQ(as_it_is.scaled_mass().blocks, 0U);

    // 2 sqrt(m / k): the step grows with the root of the mass.
    const double factor = std::pow(of_cubes.step_s() / as_it_is.step_s(), 2);
    const ScaledMass added = scaled.scaled_mass();
    EXPECT_EQ(added.blocks, 1U);
    EXPECT_NEAR(added.largest_factor, factor, 1e-9 * factor);
    const double plate_m3 = 1.6, cubes_m3 = 80.0;
    EXPECT_NEAR(added.added_share, (factor - 1.0) * plate_m3 / (plate_m3 + cubes_m3), 1e-9);

    // With its weight: it falls as all others do, and what is reported is the energy of the rock it is.
    scaled.advance(static_cast<std::uint64_t>(0.8 / scaled.step_s()));
    const Block& plate = scaled.blocks()[10];
    EXPECT_NEAR(plate.velocity_mps.z(), scaled.blocks()[0].velocity_mps.z(), 1e-9);
    EXPECT_NEAR(plate.own_energy_j(), 0.5 * 2500.0 * plate_m3 * plate.velocity_mps.squaredNorm(),
                1e-6 * plate.own_energy_j());
    scaled.advance(static_cast<std::uint64_t>(4.0 / scaled.step_s()));
    EXPECT_LT(std::abs(residual_share(scaled)), 0.01);
}

TEST(MassScaling, OfAHeldMassLeavesNoTrace) {
    const std::vector<BlockStart> blocks = cubes_and_a_plate();
    RockMass mass{Laws{}, blocks, {}, Ground{plane_of(0.0)}};
    const RockMass other{Laws{}, blocks, {}, Ground{plane_of(0.0)}};
    mass.hold();
    EXPECT_GT(mass.step_s(), 1.2 * other.step_s());
    EXPECT_DOUBLE_EQ(mass.step_s(), other.step_when_held_s());
    mass.advance(100);
    mass.let_go();
    EXPECT_EQ(mass.step_s(), other.step_s());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        EXPECT_EQ(mass.blocks()[i].mass_kg, other.blocks()[i].mass_kg);
        EXPECT_EQ(mass.blocks()[i].inertia_kgm2, other.blocks()[i].inertia_kgm2);
    }
}

/// Cells of many sizes: those of less than the middle one have more inertia while they are held.
TEST(HeldMass, ComesToRestAtAnyStepFactor) {
    std::vector<BlockStart> blocks;
    for (const ConvexCell& cell : voronoi_cells({0.0, 0.0, 0.0}, {6.0, 6.0, 9.0}, 1.5, 1)) {
        blocks.push_back(block_of(solids::convex_hull(corners_of(cell)), 2500.0, false));
    }
    for (const double factor : {0.1, 0.2, 0.3, 0.4, 0.5}) {
        Laws laws;
        laws.step_factor = factor;
        RockMass mass{laws, blocks, {}, Ground{plane_of(0.0)}};
        EXPECT_GT(mass.unbalanced_share(), 0.9) << "nothing presses yet";
        mass.hold();
        mass.advance(static_cast<std::uint64_t>(2.0 / mass.step_s()));
        EXPECT_LT(mass.unbalanced_share(), 1e-3) << factor;
    }
}

}  // namespace
}  // namespace rockfall::rock_mass
