#include "coupling/assessments/collapse/hand_over.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/units/constants.hpp"
#include "tests/coupling/assessments/collapse/handing_mass.hpp"

namespace coupling::collapse {
namespace {

using Eigen::Vector3d;
using rockfall::rock_mass::BlockStatus;
using rockfall::rock_mass::HandedBlock;
using rockfall::rock_mass::RockMass;

TEST_F(HandOvers, EnergiesOfAFallCloseOverItsWholeWay) {
    const HandedBlock block = thrown(at(1100.0, 2070.0, 12.0), {8.0, 0.0, 1.0});
    const HandedFall fall = followed(block);
    ASSERT_TRUE(rockfall::came_to_rest(fall.end.reason)) << static_cast<int>(fall.end.reason);
    ASSERT_GT(fall.end.ground_impacts, 0U);
    const double fallen_m = block.centre_m.z() - fall.moments.back().centre_m.z();
    const double given_j = block.motion_j + solid()->mass_kg * config::gravity_mps2 * fallen_m;
    EXPECT_GT(fallen_m, 12.0);
    EXPECT_NEAR(fall.start_j, given_j, 1e-9 * given_j);
    // All that it had is dissipated, up to what its own ledger says is missing.
    EXPECT_NEAR(given_j + fall.end.corrected_j - fall.end.dissipated_j, -fall.end.residual_j, 1e-9 * given_j);
    EXPECT_LT(std::abs(fall.end.residual_j), 0.01 * given_j);
}

TEST_F(HandOvers, MomentsBeginWhereTheMassLeftTheBlockAndLieOnItsWay) {
    const HandedBlock block = thrown(at(1100.0, 2070.0, 12.0), {8.0, 0.0, 1.0});
    const HandedFall fall = followed(block);
    ASSERT_GT(fall.moments.size(), 20U);
    EXPECT_EQ(fall.moments.front().centre_m, block.centre_m);
    EXPECT_EQ(fall.moments.front().velocity_mps, block.velocity_mps);
    EXPECT_NEAR(fall.moments.front().translation_j + fall.moments.front().rotation_j, block.motion_j,
                1e-9 * block.motion_j);
    // In free flight the parabola and a free rotation.
    for (int k = 1; k <= 10; ++k) {
        const double t = k * look_s;
        const Vector3d there =
            block.centre_m + t * block.velocity_mps - Vector3d{0.0, 0.0, 0.5 * config::gravity_mps2 * t * t};
        const HandedMoment& moment = fall.moments[static_cast<std::size_t>(k)];
        EXPECT_LT((moment.centre_m - there).norm(), 1e-8) << k;
        const auto turned = rockfall::solids::rotate_free(block.rotation, solid()->inertia_kgm2, t);
        EXPECT_GT(std::abs(moment.attitude.dot(turned.attitude)), 0.999) << k;
        EXPECT_NEAR(moment.rotation_j, fall.moments.front().rotation_j, 1e-6 * moment.rotation_j);
    }
    EXPECT_EQ(fall.moments.back().velocity_mps, Vector3d{Vector3d::Zero()});
    EXPECT_NEAR(static_cast<double>(fall.moments.size() - 2) * look_s, fall.duration_s, look_s);
}

TEST_F(HandOvers, TreesTakeWhatTheFallLosesToThem) {
    ASSERT_FALSE(site.trees.empty());
    const rockfall::PlacedStem& stem = site.handed_ground->stems().placed()[0];
    HandedBlock block = thrown({stem.x_m - 3.0, stem.y_m, stem.ground_m + 3.0}, {12.0, 0.0, 0.0});
    const HandedFall fall = followed(block);
    ASSERT_FALSE(fall.blows.empty());
    EXPECT_EQ(fall.blows.front().stem, 0U);
    EXPECT_LT(fall.blows.front().after_s, 3.0 / 12.0);
    EXPECT_EQ(fall.blows.size(), fall.end.tree_hits);
    EXPECT_GT(fall.blows.front().energy_j, 0.0);
}

TEST_F(HandOvers, OnlyBlocksOverUntouchedTerrainLeave) {
    const auto untouched = [&](double east_m, double north_m) {
        return site.handed_ground->is_untouched(site.ground, at(east_m, north_m, 0.0).head<2>(), 1.0);
    };
    EXPECT_FALSE(untouched(1064.0, 2072.0));  // in the middle of the source
    EXPECT_FALSE(untouched(1051.5, 2072.0));  // at its border
    EXPECT_TRUE(untouched(1100.0, 2072.0));
    EXPECT_FALSE(site.handed_ground->is_untouched(site.ground, {1e5, 1e5}, 1.0));  // beyond the terrain
}

TEST_F(HandOvers, HandsABlockOverOnceItWasAloneForLongEnough) {
    RockMass mass = flying();
    mass.watch_lone_blocks();
    const auto steps = static_cast<std::uint64_t>(look_s / mass.step_s());
    const double interval_s = static_cast<double>(steps) * mass.step_s();
    HandOver hand_over{*scenario, site, interval_s, 1, rockfall::rock_mass::one_by_one};
    while (mass.time_s() < 0.28) {
        mass.advance(steps);
        hand_over.look(mass);
        EXPECT_EQ(hand_over.fall_of(0), nullptr) << mass.time_s();
    }
    const double before_j = mass.ledger().residual_j();
    while (mass.time_s() < 0.45) {
        mass.advance(steps);
        hand_over.look(mass);
    }
    ASSERT_NE(hand_over.fall_of(0), nullptr);
    EXPECT_EQ(mass.blocks()[0].status, BlockStatus::handed);
    EXPECT_NEAR(hand_over.handed_at_s(0), 0.3, look_s + 0.01);
    EXPECT_NEAR(mass.ledger().residual_j(), before_j, 1e-3 * mass.ledger().turnover_j(0.0));
    const SeenBlock seen = hand_over.seen(mass, 0);
    EXPECT_TRUE(seen.is_handed);
    EXPECT_EQ(seen.status, BlockStatus::moving);
    const Vector3d start = at(1100.0, 2070.0, 60.0);
    EXPECT_NEAR(seen.centre_m.x() - start.x(), 8.0 * mass.time_s(), 1e-6);
    EXPECT_FALSE(hand_over.is_over(mass.time_s()));
    EXPECT_TRUE(hand_over.is_over(mass.time_s() + 700.0));
}

TEST_F(HandOvers, GoOnFromTheirNumbersAndRefuseOthers) {
    RockMass mass = flying();
    mass.watch_lone_blocks();
    HandOver hand_over{*scenario, site, look_s, 1, rockfall::rock_mass::one_by_one};
    while (mass.time_s() < 0.6) {
        mass.advance(20);
        hand_over.look(mass);
    }
    const std::vector<double> numbers = hand_over.packed();
    ASSERT_FALSE(hand_over.falls().empty());
    HandOver resumed{*scenario, site, look_s, 1, rockfall::rock_mass::one_by_one};
    ASSERT_TRUE(resumed.unpack(numbers, mass));
    EXPECT_EQ(resumed.packed(), numbers);
    ASSERT_EQ(resumed.falls().size(), hand_over.falls().size());
    for (std::size_t f = 0; f < resumed.falls().size(); ++f) {
        ASSERT_EQ(resumed.falls()[f].moments.size(), hand_over.falls()[f].moments.size());
        for (std::size_t k = 0; k < resumed.falls()[f].moments.size(); ++k) {
            EXPECT_EQ(resumed.falls()[f].moments[k].centre_m, hand_over.falls()[f].moments[k].centre_m);
        }
        EXPECT_EQ(resumed.falls()[f].end.dissipated_j, hand_over.falls()[f].end.dissipated_j);
    }
    const auto accepts = [&](const std::vector<double>& other) {
        HandOver fresh{*scenario, site, look_s, 1, rockfall::rock_mass::one_by_one};
        return fresh.unpack(other, mass);
    };
    for (std::size_t size = 0; size < numbers.size(); ++size) {
        EXPECT_FALSE(accepts({numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
    }
    std::vector<double> other = numbers;
    other.push_back(0.0);
    EXPECT_FALSE(accepts(other));
    other = numbers;
    other[2] = 1e9;  // a block that is none
    EXPECT_FALSE(accepts(other));
    const RockMass untouched = flying();  // nothing was handed over there
    HandOver fresh{*scenario, site, look_s, 1, rockfall::rock_mass::one_by_one};
    EXPECT_FALSE(fresh.unpack(numbers, untouched));
}

TEST_F(HandOvers, EndAtAnyTimeInAStateOfTheWholeFall) {
    const HandedBlock block = thrown(at(1100.0, 2070.0, 12.0), {8.0, 0.0, 1.0});
    const HandedFall whole = followed(block);
    ASSERT_TRUE(whole.has_ended);
    for (int k = 1; k < 60; ++k) {
        const double until_s = whole.duration_s * k / 60.0;
        const HandedFall part = followed(block, until_s);
        ASSERT_FALSE(part.has_ended) << k;
        EXPECT_EQ(part.duration_s, until_s) << k;
        // Its ledger closes over the part that it went.
        EXPECT_NEAR(part.start_j + part.end.corrected_j - part.end.dissipated_j - part.motion_end_j,
                    -part.end.residual_j, 1e-9 * whole.start_j)
            << k;
        EXPECT_LT(std::abs(part.end.residual_j), 1e-3 * whole.start_j) << k;
        // What happened before is the same, bit by bit.
        ASSERT_LE(part.blows.size(), whole.blows.size());
        for (std::size_t blow = 0; blow < part.blows.size(); ++blow) {
            EXPECT_EQ(part.blows[blow].after_s, whole.blows[blow].after_s);
            EXPECT_LE(part.blows[blow].after_s, until_s);
            EXPECT_EQ(part.blows[blow].energy_j, whole.blows[blow].energy_j);
        }
        for (std::size_t moment = 0; moment + 2 < part.moments.size(); ++moment) {
            EXPECT_EQ(part.moments[moment].centre_m, whole.moments[moment].centre_m) << k;
        }
        // And the end lies on the way: moments on the ground are taken from chords of a fiftieth of a second.
        const auto before = static_cast<std::size_t>(until_s / look_s);
        const double way_m = (part.last.centre_m - whole.moments[before].centre_m).norm();
        const double speed_mps = std::max(whole.moments[before].velocity_mps.norm(),
                                          whole.moments[before + 1].velocity_mps.norm());
        EXPECT_LE(way_m, 1.3 * (speed_mps + 1.0) * look_s + 0.02) << k;
    }
    const HandedFall later = followed(block, whole.duration_s + 1.0);
    EXPECT_TRUE(later.has_ended);
    EXPECT_EQ(later.duration_s, whole.duration_s);
    EXPECT_EQ(later.end.dissipated_j, whole.end.dissipated_j);
    EXPECT_EQ(later.last.centre_m, whole.last.centre_m);
}

TEST_F(HandOvers, HandNothingOverUnlessAsked) {
    const auto none = read_collapse(project.file("scenario.ini"), {"collapse.depth_m=6"});
    config::Warnings warnings;
    const CollapseSite plain = open_collapse(*none, warnings);
    EXPECT_EQ(plain.handed_ground, nullptr);
    RockMass mass = flying();
    HandOver hand_over{*none, plain, look_s, 1, rockfall::rock_mass::one_by_one};
    mass.advance(1000);
    hand_over.look(mass);
    EXPECT_TRUE(hand_over.falls().empty());
    EXPECT_FALSE(hand_over.seen(mass, 0).is_handed);
}

TEST(GuardsOfALook, DivideItsStepsAndNearlyKeepItsLength) {
    for (std::uint64_t steps = 1; steps < 1000; ++steps) {
        const GuardPlan plan = guards_for(steps);
        ASSERT_GE(plan.steps_of_guard, 1U) << steps;
        ASSERT_GE(plan.guards, std::min<std::uint64_t>(4, steps)) << steps;
        ASSERT_LE(plan.guards, 7U) << steps;
        const double change = std::abs(static_cast<double>(plan.steps()) / static_cast<double>(steps) - 1.0);
        EXPECT_LE(change, steps <= 8 ? 0.0 : 1.0 / 9.0 + 1e-12) << steps;
    }
}

TEST_F(HandOvers, DrawAnewAtTreesInALaterFallOfTheSameBlock) {
    const rockfall::PlacedStem& stem = site.handed_ground->stems().placed()[0];
    const HandedBlock block = thrown({stem.x_m - 3.0, stem.y_m, stem.ground_m + 3.0}, {12.0, 0.0, 0.0});
    const HandedFall first = followed(block);
    const HandedFall second = followed(block, std::numeric_limits<double>::infinity(), 1);
    ASSERT_FALSE(first.blows.empty());
    ASSERT_FALSE(second.blows.empty());
    // Up to the tree they are one fall.
    EXPECT_EQ(first.blows.front().after_s, second.blows.front().after_s);
    EXPECT_EQ(first.blows.front().stem, second.blows.front().stem);
    const auto before = static_cast<std::size_t>(first.blows.front().after_s / look_s);
    EXPECT_EQ(first.moments[before].centre_m, second.moments[before].centre_m);
    EXPECT_NE(first.moments[before + 1].velocity_mps, second.moments[before + 1].velocity_mps);
}

TEST_F(HandOvers, MeetTheSameBumpsOfTheGroundInEachFall) {
    open({"collapse.hand_over=rigid", "collapse.depth_m=6", "terrain.ground=coarse_debris",
          "rigid.roughness_m=0.3"});
    // A block that is smaller than the cells of the terrain.
    std::iter_swap(
        site.blocks.begin(),
        std::min_element(site.blocks.begin(),
                         site.blocks.begin() + static_cast<std::ptrdiff_t>(site.count.free),
                         [](const auto& a, const auto& b) { return a.solid.volume_m3 < b.solid.volume_m3; }));
    const HandedBlock block = thrown(at(1100.0, 2070.0, 12.0), {8.0, 0.0, 1.0});
    const auto without_trees = [&](std::uint64_t seed, std::uint32_t earlier_falls) {
        return follow(*site.handed_ground, {&scenario->scenario.rockfall.fall, seed, look_s}, block, solid(),
                      std::vector<std::uint8_t>(site.handed_ground->stems().placed().size(), 1),
                      earlier_falls);
    };
    const HandedFall first = without_trees(1, 0);
    ASSERT_GT(first.end.ground_impacts, 0U);
    EXPECT_NE(without_trees(2, 0).last.centre_m, first.last.centre_m) << "it meets bumps";
    EXPECT_EQ(without_trees(1, 1).last.centre_m, first.last.centre_m);
    EXPECT_EQ(without_trees(1, 7).end.dissipated_j, first.end.dissipated_j);
}

TEST_F(HandOvers, NumberTheFallsOfEachBlock) {
    const rockfall::PlacedStem& stem = site.handed_ground->stems().placed()[0];
    const Vector3d to_m{stem.x_m, stem.y_m, stem.ground_m + 3.0};
    HandedBlock away;
    away.centre_m = at(1225.0, 2010.0, site.blocks[1].solid.bounding_radius_m);
    RockMass mass = two(flying_to(to_m, to_m + Vector3d{-12.0, 0.0, 12.0}, 1.0), away);
    std::vector<double> numbers{1.0};
    const HandedBlock leaves = mass.hand_over(std::vector<std::uint32_t>{0}).front();
    const std::vector<double> crossing = numbers_of_crossing(leaves);
    numbers.insert(numbers.end(), crossing.begin(), crossing.end());
    HandOver hand_over = hand_over_for(mass);
    ASSERT_TRUE(hand_over.unpack(numbers, mass));
    const HandedFall& only = hand_over.falls()[0];
    ASSERT_FALSE(only.blows.empty());
    // As if the block had come back on its way and had left again as it did before.
    std::vector<double> returned = crossing;
    constexpr std::size_t returns_at = 19;  // time, number, contact and 16 numbers of the block are before
    ASSERT_EQ(returned.at(returns_at), 0.0);
    returned[returns_at] = 1.0;
    const double returned_s = hand_over.start_s(0) + only.blows.front().after_s + look_s;
    const std::vector<double> back{returned_s, 0.0, 0.0, 0.0};
    returned.insert(returned.begin() + returns_at + 1, back.begin(), back.end());
    numbers = {2.0};
    numbers.insert(numbers.end(), returned.begin(), returned.end());
    numbers.insert(numbers.end(), crossing.begin(), crossing.end());
    HandOver twice = hand_over_for(mass);
    ASSERT_TRUE(twice.unpack(numbers, mass));
    ASSERT_EQ(twice.falls().size(), 2U);
    const HandedBlock& block = only.block;
    const double until_s = returned_s - hand_over.start_s(0);
    EXPECT_EQ(twice.falls()[0].last.velocity_mps, followed(block, until_s, 0).last.velocity_mps);
    EXPECT_EQ(twice.falls()[1].last.centre_m,
              followed(block, std::numeric_limits<double>::infinity(), 1).last.centre_m);
    EXPECT_NE(twice.falls()[1].last.centre_m, only.last.centre_m);
}

TEST_F(HandOvers, CloseTheLedgersOfFallsThatLeaveTheTerrain) {
    const auto expect_closed = [](const HandedFall& fall) {
        EXPECT_GT(fall.motion_end_j, 0.1 * fall.start_j);
        EXPECT_NEAR(fall.start_j + fall.end.corrected_j - fall.end.dissipated_j - fall.motion_end_j,
                    -fall.end.residual_j, 1e-9 * fall.start_j);
        EXPECT_LT(std::abs(fall.end.residual_j), 1e-3 * fall.start_j);
    };
    for (const double above_m : {2.0, 4.0, 12.0}) {
        for (const double speed_mps : {30.0, 60.0}) {
            const HandedFall leaves = followed(thrown(at(1225.0, 2070.0, above_m), {speed_mps, 0.0, 0.0}));
            ASSERT_EQ(leaves.end.reason, rockfall::StopReason::left_terrain) << above_m;
            expect_closed(leaves);
        }
    }
}

}  // namespace
}  // namespace coupling::collapse
