#include "rockfall/rock_mass/lone_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using namespace scenes;

using Numbers = std::vector<std::uint32_t>;

/// A slope of 0.6 with friction 0.3: one cube slides down it, two bonded ones slide beside it, one lies on a
/// fixed one, and one falls.
RockMass slide() {
    constexpr double rise = 0.6;
    const double above_m = 0.5 * std::hypot(1.0, rise);
    const Eigen::Quaterniond turn{Eigen::AngleAxisd{-std::atan(rise), Vector3d::UnitY()}};
    const auto lying_at = [&](double x, double y) {
        return block_of(solids::placed(solids::box(Vector3d::Ones()), turn, {x, y, rise * x + above_m}),
                        2500.0, false);
    };
    std::vector<BlockStart> blocks{lying_at(0.0, 0.0),
                                   lying_at(0.0, 20.0),
                                   lying_at(0.0, 21.0),
                                   cube_at({50.0, 0.0, 60.0}, 1.0, 2500.0, true),
                                   cube_at({50.0, 0.0, 61.0}, 1.0),
                                   cube_at({50.0, 20.0, 120.0}, 1.0)};
    std::vector<BondStart> bonds{bond_between(1, 2, {0.0, 20.0, above_m}, {0.0, 21.0, above_m}, 1.0)};
    Laws laws;
    return {laws, blocks, bonds, Ground{plane_of(rise)}};
}

void advance_to(RockMass& mass, double time_s) {
    while (mass.time_s() < time_s) {
        mass.step();
    }
}

TEST(LoneBlocks, AreThoseWithoutBondAndContactThatMove) {
    RockMass mass = slide();
    mass.watch_lone_blocks();
    advance_to(mass, 0.9);
    EXPECT_EQ(mass.lone_blocks(1.0), Numbers{});
    advance_to(mass, 1.5);
    EXPECT_EQ(mass.lone_blocks(1.0), (Numbers{0, 5}));  // on the ground and in the air
    EXPECT_EQ(mass.lone_blocks(2.0), Numbers{});
}

TEST(LoneBlocks, AreNotThoseThatTheGroundIsAboutToThrowBack) {
    // A cube falls flat on a plane: at the bottom of its impact the ground holds nearly all that it has.
    std::vector<BlockStart> blocks{cube_at({0.0, 0.0, 5.5}, 1.0)};
    Laws laws;
    laws.damping_ratio = 0.0;
    RockMass mass{laws, blocks, {}, Ground{plane_of(0.0)}};
    mass.watch_lone_blocks();
    bool was_held_back = false;
    double slowest_j = 1e99;
    while (mass.time_s() < 2.0) {
        mass.step();
        const double motion_j = mass.blocks()[0].energy_j();
        const double strain_j = mass.ledger().contact_normal_j;
        const bool is_fast = mass.blocks()[0].velocity_mps.norm() > lone_speed_mps;
        if (mass.time_s() > 0.2) {
            EXPECT_EQ(mass.lone_blocks(0.1).size(),
                      is_fast && strain_j <= lone_strain_share * motion_j ? 1U : 0U)
                << mass.time_s();
        }
        was_held_back = was_held_back || (is_fast && strain_j > lone_strain_share * motion_j);
        slowest_j = std::min(slowest_j, motion_j);
    }
    EXPECT_TRUE(was_held_back);
    EXPECT_LT(slowest_j, 0.01 * 2500.0 * 9.81 * 5.0);
}

TEST(LoneBlocks, TakeTheirEnergiesOutOfTheLedgerToTheLastJoule) {
    RockMass mass = slide();
    mass.watch_lone_blocks();
    advance_to(mass, 1.5);
    const Ledger before = mass.ledger();
    const double motion_j = mass.blocks()[0].energy_j() + mass.blocks()[5].energy_j();
    const double fallen_m = mass.blocks()[0].start_height_m - mass.blocks()[0].centre_m.z() +
                            mass.blocks()[5].start_height_m - mass.blocks()[5].centre_m.z();
    const auto handed = mass.hand_over(mass.lone_blocks(1.0));
    ASSERT_EQ(handed.size(), 2U);
    EXPECT_TRUE(handed[0].on_ground);
    EXPECT_FALSE(handed[1].on_ground);
    EXPECT_GT(handed[0].strain_j, 0.0);
    EXPECT_EQ(handed[1].strain_j, 0.0);
    const Ledger after = mass.ledger();
    const double rounding_j = 1e-12 * before.turnover_j(0.0);
    EXPECT_NEAR(after.handed_motion_j, motion_j, rounding_j);
    EXPECT_NEAR(after.handed_gravity_j, -2500.0 * 9.81 * fallen_m, rounding_j);
    EXPECT_NEAR(after.translation_j + after.rotation_j + motion_j, before.translation_j + before.rotation_j,
                rounding_j);
    EXPECT_NEAR(after.residual_j(), before.residual_j(), rounding_j);
    EXPECT_NEAR(after.given_by_gravity_j(), before.given_by_gravity_j(), rounding_j);

    // What stays goes on without them, and so does its ledger.
    advance_to(mass, 2.5);
    EXPECT_EQ(mass.ledger().handed_j(), after.handed_j());
    EXPECT_EQ(mass.blocks()[0].status, BlockStatus::handed);
    EXPECT_LT(std::abs(residual_share(mass)), 0.01);
    EXPECT_EQ(mass.lone_blocks(1.0), Numbers{});
}

TEST(LoneBlocks, AreKeptWithTheState) {
    const auto begun = [] {
        RockMass mass = slide();
        mass.watch_lone_blocks();
        return mass;
    };
    RockMass whole = begun();
    advance_to(whole, 0.7);
    whole.refresh();
    const std::vector<double> early = whole.packed();
    advance_to(whole, 1.5);
    whole.hand_over(whole.lone_blocks(1.0));
    const std::vector<double> late = whole.packed();

    RockMass resumed = begun();
    ASSERT_TRUE(resumed.unpack(early));
    advance_to(resumed, 1.5);
    resumed.hand_over(resumed.lone_blocks(1.0));
    EXPECT_EQ(resumed.packed(), late);

    RockMass again = begun();
    ASSERT_TRUE(again.unpack(late));
    EXPECT_EQ(again.packed(), late);
}

BlockBack as_it_left(const HandedBlock& block) {
    return {block.number, block.centre_m, block.velocity_mps, block.rotation};
}

double motion_and_height_j(const Block& block) {
    return block.energy_j() + block.weight_n * block.centre_m.z();
}

TEST(BlocksThatComeBack, BringTheirEnergiesIntoTheLedgerToTheLastJoule) {
    RockMass mass = slide();
    mass.watch_lone_blocks();
    advance_to(mass, 1.5);
    const auto handed = mass.hand_over(mass.lone_blocks(1.0));
    ASSERT_EQ(handed.size(), 2U);
    advance_to(mass, 2.0);
    const Ledger before = mass.ledger();
    // Both have lost some motion and height on their way; the second one is in the air.
    std::vector<BlockBack> backs{as_it_left(handed[0]), as_it_left(handed[1])};
    for (BlockBack& back : backs) {
        back.velocity_mps *= 0.5;
        back.centre_m += Vector3d{-2.0, 0.0, 0.0};
    }
    const auto taken = mass.take_back(backs);
    ASSERT_EQ(taken.size(), 2U);
    const Ledger after = mass.ledger();
    const double rounding_j = 1e-12 * before.turnover_j(0.0);
    EXPECT_NEAR(after.residual_j(), before.residual_j(), rounding_j);
    EXPECT_NEAR(after.given_by_gravity_j(), before.given_by_gravity_j(), rounding_j);
    EXPECT_NEAR(after.back_motion_j, taken[0].motion_j + taken[1].motion_j, rounding_j);
    EXPECT_EQ(after.back_strain_j, 0.0);
    EXPECT_EQ(mass.blocks()[0].status, BlockStatus::moving);
    EXPECT_EQ(mass.blocks()[5].velocity_mps, backs[1].velocity_mps);
    EXPECT_EQ(mass.lone_blocks(0.0), Numbers{}) << "they have to be alone for long enough once more";
    advance_to(mass, 4.0);
    EXPECT_LT(std::abs(residual_share(mass)), 0.01);
    EXPECT_EQ(mass.lone_blocks(1.0), (Numbers{0, 5}));
}

TEST(BlocksThatComeBack, AreLiftedOutOfTheGroundAtTheCostOfTheirMotion) {
    for (const double depth_m : {0.01, 0.1, 0.7}) {
        RockMass mass = slide();
        mass.watch_lone_blocks();
        advance_to(mass, 1.5);
        const auto handed = mass.hand_over(mass.lone_blocks(1.0));
        BlockBack back = as_it_left(handed[0]);
        // A cube that lay on the slope: its faces are along it, so that all of it lies so deep in the ground.
        back.centre_m.z() = 0.6 * back.centre_m.x() + 0.5 * std::hypot(1.0, 0.6) - depth_m;
        back.velocity_mps = {-9.0, 0.0, -5.4};
        const double before_j = 0.5 * 2500.0 * back.velocity_mps.squaredNorm() +
                                back.rotation.energy_j(mass.blocks()[0].inertia_kgm2) +
                                2500.0 * 9.81 * back.centre_m.z();
        const Ledger before = mass.ledger();
        const auto taken = mass.take_back(std::vector{back});
        EXPECT_NEAR(taken[0].lift_m, depth_m, 1e-3) << depth_m;
        EXPECT_NEAR(motion_and_height_j(mass.blocks()[0]), before_j, 1e-4 * before_j) << depth_m;
        EXPECT_NEAR(mass.ledger().residual_j(), before.residual_j(), 1e-9 * before_j) << depth_m;
        EXPECT_NEAR(mass.ledger().contact_normal_j, before.contact_normal_j, 1e-9 * before_j) << depth_m;
        // Nothing is thrown up by what the ground would have held.
        const double height_j = motion_and_height_j(mass.blocks()[0]);
        advance_to(mass, 2.5);
        EXPECT_LE(motion_and_height_j(mass.blocks()[0]), height_j + 1e-3 * before_j) << depth_m;
    }
}

TEST(BlocksThatComeBack, AreWhatTheyWereWhenTheyLeft) {
    // A thin plate whose mass is scaled up, turning in the air, beside cubes that set the step.
    std::vector<BlockStart> blocks{
        block_of(solids::placed(solids::box({1.0, 1.0, 0.1}), Eigen::Quaterniond::Identity(), {0, 0, 50}),
                 2500.0, false)};
    for (int k = 0; k < 9; ++k) {
        blocks.push_back(cube_at({50.0 + 5.0 * k, 0.0, 5.5}, 1.0));
    }
    blocks[0].velocity_mps = {3.0, 0.0, 0.0};
    blocks[0].momentum_nms = 2.0 * blocks[0].solid.inertia_kgm2;
    Laws laws;
    laws.heavier_share = 0.1;
    RockMass mass{laws, blocks, {}, Ground{plane_of(0.0)}};
    ASSERT_GT(mass.blocks()[0].mass_factor, 1.5);
    mass.watch_lone_blocks();
    advance_to(mass, 1.2);
    const Block was = mass.blocks()[0];
    const Ledger before = mass.ledger();
    const auto handed = mass.hand_over(Numbers{0});
    const Vector3d own_spin = handed[0].rotation.spin_radps(blocks[0].solid.inertia_kgm2);
    EXPECT_LT((own_spin - was.spin_radps()).norm(), 1e-12) << "the spin is its own";
    EXPECT_NEAR(handed[0].rotation.energy_j(blocks[0].solid.inertia_kgm2) +
                    0.5 * blocks[0].solid.mass_kg * was.velocity_mps.squaredNorm(),
                handed[0].motion_j, 1e-9 * handed[0].motion_j);
    mass.take_back(std::vector{as_it_left(handed[0])});
    const Block& is = mass.blocks()[0];
    EXPECT_EQ(is.centre_m, was.centre_m);
    EXPECT_EQ(is.velocity_mps, was.velocity_mps);
    EXPECT_LT((is.rotation.momentum_nms - was.rotation.momentum_nms).norm(),
              1e-12 * was.rotation.momentum_nms.norm());
    EXPECT_NEAR(mass.ledger().handed_j(), 0.0, 1e-12 * before.turnover_j(0.0));
    EXPECT_NEAR(mass.ledger().residual_j(), before.residual_j(), 1e-12 * before.turnover_j(0.0));
}

TEST(BlocksThatComeBack, BookTheOverlapWithWhichTheyCome) {
    RockMass mass = slide();
    mass.watch_lone_blocks();
    advance_to(mass, 1.5);
    auto handed = mass.hand_over(mass.lone_blocks(1.0));
    BlockBack back = as_it_left(handed[1]);
    back.centre_m = mass.blocks()[4].centre_m + Vector3d{0.2, 0.1, 0.95};  // 5 cm in the cube that lies there
    back.velocity_mps.setZero();
    back.rotation = mass.blocks()[4].rotation;
    const Ledger before = mass.ledger();
    const auto taken = mass.take_back(std::vector{back});
    ASSERT_GT(taken[0].strain_j, 1000.0);
    mass.step();
    const Ledger after = mass.ledger();
    EXPECT_GT(after.contact_normal_j, before.contact_normal_j + 0.5 * taken[0].strain_j);
    EXPECT_NEAR(after.residual_j(), before.residual_j(), 0.01 * taken[0].strain_j);
    EXPECT_EQ(after.back_strain_j, taken[0].strain_j);
}

TEST(BlocksThatComeBack, AreKeptWithTheState) {
    const auto begun = [] {
        RockMass mass = slide();
        mass.watch_lone_blocks();
        return mass;
    };
    RockMass whole = begun();
    advance_to(whole, 1.5);
    const auto handed = whole.hand_over(whole.lone_blocks(1.0));
    advance_to(whole, 1.7);
    whole.take_back(std::vector{as_it_left(handed[1])});
    const std::vector<double> state = whole.packed();
    advance_to(whole, 2.5);
    whole.refresh();

    RockMass resumed = begun();
    ASSERT_TRUE(resumed.unpack(state));
    EXPECT_EQ(resumed.packed(), state);
    advance_to(resumed, 2.5);
    resumed.refresh();
    EXPECT_EQ(resumed.packed(), whole.packed());
}

TEST(LoneBlocks, BreakStemsForTheMassWithoutItsLedger) {
    const std::vector<BlockStart> blocks{cube_at({0.0, 0.0, 5.0}, 1.0)};
    RockMass mass{Laws{}, blocks, {}, Ground{plane_of(0.0)}, {{3.0, 0.0, 0.0, 20.0, 0.2, 1e6}}};
    mass.load_stem(0, 2e5, false);
    EXPECT_FALSE(mass.stems()[0].is_broken());
    mass.load_stem(0, 3e5, true);
    EXPECT_TRUE(mass.stems()[0].is_broken());
    EXPECT_EQ(mass.stems()[0].taken_j, 5e5);
    EXPECT_EQ(mass.ledger().trees_j, 0.0);
}

}  // namespace
}  // namespace rockfall::rock_mass
