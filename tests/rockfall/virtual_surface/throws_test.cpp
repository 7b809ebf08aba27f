#include "rockfall/virtual_surface/throws.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "rockfall/virtual_surface/estimate.hpp"
#include "rockfall/virtual_surface/sweep.hpp"

namespace rockfall::throws_test {
namespace {

const double central_sine = std::sin(config::Angle::from_degrees(25.0).in_radians());

/// One block in the middle of a patch of 24 m.
BlockCover single_block(double radius_m, double burial = 0.0) {
    BlockCover cover{default_patch_m, 2.0 * radius_m};
    cover.add({12.0, 12.0, radius_m * (1.0 - 2.0 * burial), radius_m});
    return cover;
}

BlockCover scattered(double share, double gathering = 0.0, std::uint32_t number = 0) {
    BlockKind kind;
    kind.cover = share;
    kind.burial = 0.25;
    kind.gathering = gathering;
    return lay_blocks(std::array{kind}, default_patch_m, {8, number});
}

/// Width across its path on which a level rolling rock hits a block within the central angle [m].
double central_width_m(const Block& block, double rock_radius_m) {
    const double widest_m = (rock_radius_m + block.radius_m) * central_sine;
    const double above_m = rock_radius_m - block.z_m;
    return 2.0 * std::sqrt(std::max(0.0, widest_m * widest_m - above_m * above_m));
}

TEST(Sweep, MeetsABlockHeadOnWhereTheSurfacesTouch) {
    const BlockCover cover = single_block(0.5);
    const Sweep sweep{cover, 1.0};
    const auto contact = sweep.first_contact({2.0, 12.0, 0.5}, {1.0, 0.0, 0.0}, 20.0);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->along_m, 9.0, 1e-12);
    EXPECT_NEAR((contact->towards - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12);
    EXPECT_FALSE(sweep.first_contact({2.0, 12.0, 0.5}, {1.0, 0.0, 0.0}, 8.9));
    EXPECT_FALSE(sweep.first_contact({2.0, 13.1, 0.5}, {1.0, 0.0, 0.0}, 20.0));
    EXPECT_FALSE(sweep.first_contact({12.5, 12.0, 0.5}, {1.0, 0.0, 0.0}, 5.0));  // begins in touch
}

TEST(Sweep, MeetsTheBlockOnTheOtherSideOfTheBorder) {
    const BlockCover cover = single_block(0.5);
    const Sweep sweep{cover, 1.0};
    const auto contact = sweep.first_contact({14.0, 12.0 + 3.0 * 24.0, 0.5}, {1.0, 0.0, 0.0}, 40.0);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->along_m, 21.0, 1e-12);
}

TEST(Sweep, AtTheLevelOfABlockMeetsItByCrossSectionAndCentrallyBySine) {
    // Equal spheres, level: of evenly spaced lines across the patch a share 2 (R + r) / side touches, and
    // sin 25 deg of these centrally. A line more or less at either edge is the tolerance.
    const BlockCover cover = single_block(0.5);
    const Sweep sweep{cover, 1.0};
    constexpr int lines = 24'000;
    int touched = 0;
    int central = 0;
    for (int i = 0; i < lines; ++i) {
        const Eigen::Vector3d start{0.0, 24.0 * (i + 0.5) / lines, 0.5};
        touched += sweep.first_contact(start, Eigen::Vector3d::UnitX(), 24.0) ? 1 : 0;
        central += sweep.first_contact(start, Eigen::Vector3d::UnitX(), 24.0, central_sine) ? 1 : 0;
    }
    EXPECT_NEAR(touched, lines * 2.0 / 24.0, 2.0);
    EXPECT_NEAR(central, lines * 2.0 / 24.0 * central_sine, 2.0);
}

TEST(Sweep, SeenAlongTheFlightACircleOfDirectionsIsCentral) {
    // Parallel lines that cover the whole cross-section of a block in free flight: the central ones are those
    // within sin 25 deg of its radius, a share sin^2 25 deg = 0.1786 of the area.
    const BlockCover cover = single_block(0.5);
    const Sweep sweep{cover, 1.0};
    const double dip =
        config::Angle::from_degrees(60.0).in_radians();  // steep: no line reaches the ground first
    const Eigen::Vector3d along{std::cos(dip), 0.0, -std::sin(dip)};
    const Eigen::Vector3d up{std::sin(dip), 0.0, std::cos(dip)};
    const Eigen::Vector3d middle{12.0, 12.0, 0.5};
    constexpr int steps = 400;
    int touched = 0;
    int central = 0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const Eigen::Vector3d start = middle - 5.0 * along + (2.0 * (i + 0.5) / steps - 1.0) * up +
                                          (2.0 * (j + 0.5) / steps - 1.0) * Eigen::Vector3d::UnitY();
            const auto contact = sweep.first_contact(start, along, 5.0);
            touched += contact ? 1 : 0;
            central += contact && contact->towards.dot(along) > std::cos(std::asin(central_sine)) ? 1 : 0;
        }
    }
    EXPECT_NEAR(touched, steps * steps * std::numbers::pi / 4.0, 4.0 * steps * 0.1);
    EXPECT_NEAR(static_cast<double>(central) / touched, central_sine * central_sine, 1e-3);
}

TEST(ThrowRock, PassesWhereThereIsNoBlock) {
    const BlockCover bare{default_patch_m, 1.0};
    EXPECT_EQ(throw_rock(bare, 1.0, {}, {}), ThrowEnd::passed);
    EXPECT_EQ(throw_rocks(bare, 1.0, {}, {1, 0}, 100), (ThrowTally{100, 0, 0}));
    EXPECT_EQ(roll_rocks(bare, 1.0, {}, {1, 0}, 100), (RollTally{100, 0, 2400.0}));
}

TEST(ThrowRock, IsStoppedOnTheWayDownOrAfterTheReboundByTheSameRule) {
    // Equal spheres: the rock comes to the ground where its centre has flown 1 m / tan 15 deg = 3.732 m. A
    // block right behind that point is met on the way up, one before it on the way down.
    const BlockCover cover = single_block(0.5);
    const double run_m = 1.0 / std::tan(config::Angle::from_degrees(15.0).in_radians());
    const auto end_of = [&](double ground_x_m, double y_m) {
        return throw_rock(cover, 1.0, {ground_x_m - run_m, y_m, config::Angle::from_degrees(15.0)}, {});
    };
    EXPECT_EQ(end_of(12.0 - 1.05, 12.0), ThrowEnd::stopped);  // up, the block ahead
    EXPECT_EQ(end_of(12.0 - 0.85, 12.0), ThrowEnd::stopped);  // down, before the ground is reached
    EXPECT_EQ(end_of(12.0 - 1.05, 12.98), ThrowEnd::passed);  // beside it, risen by 0.28 m
    EXPECT_EQ(end_of(12.0 - 0.85, 12.7), ThrowEnd::touched);
    EXPECT_EQ(end_of(12.0 + 2.5, 12.0), ThrowEnd::touched);  // from above
    EXPECT_EQ(end_of(12.0 - 8.0, 12.0), ThrowEnd::passed);   // risen over it
}

TEST(ThrowRocks, AtASparseSurfaceStopWithTheSumOverItsBlocks) {
    // No block shades another at this cover of 0.2 %, so each stops by itself what it would stop alone.
    const BlockCover cover = scattered(0.002);
    constexpr std::uint32_t throws = 200'000;
    double expected = 0.0;
    for (const Block& block : cover.blocks()) {
        BlockCover alone{default_patch_m, 0.8};
        alone.add(block);
        const ThrowTally tally = throw_rocks(alone, 0.95, {}, {8, 0}, throws);
        expected += static_cast<double>(tally.stopped);
    }
    // Throws are shared, so only the different start heights tell the two sums apart.
    const double stopped = static_cast<double>(throw_rocks(cover, 0.95, {}, {8, 0}, throws).stopped);
    EXPECT_NEAR(stopped, expected, 4.0 * std::sqrt(2.0 * expected));
    EXPECT_GT(stopped, 100.0);
}

TEST(ThrowRocks, AtASparseSurfaceStopInProportionToCover) {
    const auto probability_at = [](double share) {
        std::vector<ThrowTally> tallies;
        for (std::uint32_t number = 0; number < 24; ++number) {
            tallies.push_back(throw_rocks(scattered(share, 0.0, number), 0.95, {}, {8, number}, 20'000));
        }
        return stop_probability(tallies);
    };
    const SurfaceEstimate thin = probability_at(0.001);
    const SurfaceEstimate thick = probability_at(0.004);
    EXPECT_NEAR(thick.value, 4.0 * thin.value,
                4.0 * std::hypot(thick.standard_error, 4.0 * thin.standard_error));
    EXPECT_GT(thin.value, 10.0 * thin.standard_error);
}

TEST(ThrowRocks, DoNotDependOnWhoThrowsBefore) {
    const BlockCover cover = scattered(0.1);
    const ThrowTally all = throw_rocks(cover, 0.95, {}, {8, 0}, 4000);
    throw_rocks(cover, 0.5, {}, {8, 0}, 500);
    EXPECT_EQ(throw_rocks(cover, 0.95, {}, {8, 0}, 4000), all);
    EXPECT_NE(throw_rocks(cover, 0.95, {}, {9, 0}, 4000), all);
    EXPECT_GE(all.touched, all.stopped);
}

TEST(ThrowRocks, ThatGoOnAfterATouchStopAtLaterBlocksToo) {
    ThrowLaw going_on;
    going_on.goes_on_after_a_touch = true;
    BlockKind kind;
    kind.burial = 0.0;
    for (const double share : {0.05, 0.1, 0.3}) {
        kind.cover = share;
        const BlockCover cover = lay_blocks(std::array{kind}, default_patch_m, {8, 0});
        const ThrowTally first_decides = throw_rocks(cover, 0.95, {}, {8, 0}, 20'000);
        const ThrowTally all_do = throw_rocks(cover, 0.95, going_on, {8, 0}, 20'000);
        EXPECT_GT(all_do.stopped, first_decides.stopped) << share;
        EXPECT_LT(all_do.touched, first_decides.touched) << share;  // those that pass after touches
    }
}

TEST(RollRocks, AtOneBlockAreCaughtAtItsCentralWidthPerArea) {
    // Lines are random: k hits over L metres; the rate is width / area where each is met once.
    const BlockCover cover = single_block(0.5, 0.1);
    const RollTally tally = roll_rocks(cover, 1.0, {}, {4, 0}, 100'000);
    const double width_m = central_width_m(cover.blocks().front(), 0.5);
    const double hits = 100'000 * width_m / 24.0;  // each line crosses the patch once
    EXPECT_NEAR(static_cast<double>(tally.stopped), hits, 4.0 * std::sqrt(hits));
}

TEST(RollRocks, AtASparseSurfaceAreCaughtAtTheSumOfCentralWidthsPerArea) {
    std::vector<RollTally> tallies;
    double width_m = 0.0;
    constexpr std::uint32_t surfaces = 40;
    for (std::uint32_t number = 0; number < surfaces; ++number) {
        const BlockCover cover = scattered(0.01, 0.0, number);
        tallies.push_back(roll_rocks(cover, 0.95, {}, {8, number}, 2'000));
        for (const Block& block : cover.blocks()) {
            width_m += central_width_m(block, 0.475);
        }
    }
    const SurfaceEstimate rate = rolling_stops_per_m(tallies);
    EXPECT_NEAR(rate.value, width_m / (surfaces * 24.0 * 24.0), 3.0 * rate.standard_error);
    EXPECT_LT(rate.standard_error, 0.05 * rate.value);
}

TEST(RollRocks, MuchLargerThanTheBlocksRollOverThem) {
    // Level over unburied blocks the angle at the contact is above 25 deg if (R - r) / (R + r) > sin 25 deg.
    const double ratio = (1.0 + central_sine) / (1.0 - central_sine);
    const BlockCover cover = single_block(0.2);
    EXPECT_EQ(roll_rocks(cover, 0.4 * ratio * 1.01, {}, {4, 0}, 50'000).stopped, 0U);
    EXPECT_GT(roll_rocks(cover, 0.4 * ratio * 0.95, {}, {4, 0}, 50'000).stopped, 0U);
}

/// The first touch by a look at every block and its eight nearest images.
std::optional<double> first_touch_of_all(const BlockCover& cover, const Eigen::Vector3d& centre_m,
                                         const Eigen::Vector3d& direction, double length_m, double radius_m) {
    std::optional<double> first;
    for (const Block& block : cover.blocks()) {
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const Eigen::Vector3d to{block.x_m + i * cover.side_m() - centre_m.x(),
                                         block.y_m + j * cover.side_m() - centre_m.y(),
                                         block.z_m - centre_m.z()};
                const double reach_m = radius_m + block.radius_m;
                const double abeam_m = to.dot(direction);
                const double off2 = to.squaredNorm() - abeam_m * abeam_m;
                if (abeam_m <= 0.0 || off2 >= reach_m * reach_m) {
                    continue;
                }
                const double along_m = abeam_m - std::sqrt(reach_m * reach_m - off2);
                if (along_m >= 0.0 && along_m <= length_m && (!first || along_m < *first)) {
                    first = along_m;
                }
            }
        }
    }
    return first;
}

RC_GTEST_PROP(Sweep, FindsWhatALookAtEveryBlockFinds, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint64_t>(), 0, 0, 0}, config::Purpose::test};
    const auto between = [&](double low, double high) { return low + (high - low) * stream.uniform(); };
    BlockKind kind;
    kind.low_m = between(0.1, 0.3);
    kind.high_m = kind.low_m * between(1.0, 3.0);
    kind.cover = between(0.002, 0.1);
    kind.burial = between(0.0, 0.5);
    const BlockCover cover = lay_blocks(std::array{kind}, 12.0, {*rc::gen::arbitrary<std::uint64_t>(), 0});
    const double radius_m = between(0.05, 1.0);
    const Sweep sweep{cover, 2.0 * radius_m};
    for (int line = 0; line < 50; ++line) {
        const double turn = between(0.0, 2.0 * std::numbers::pi);
        const double dip = between(-0.3, 0.3);
        const Eigen::Vector3d direction{std::cos(dip) * std::cos(turn), std::cos(dip) * std::sin(turn),
                                        std::sin(dip)};
        const Eigen::Vector3d centre_m{between(0.0, 12.0), between(0.0, 12.0), radius_m + between(0.0, 0.8)};
        // Not below the height of the radius, and no further than the nearest images reach.
        const double to_ground_m = direction.z() < 0.0 ? (centre_m.z() - radius_m) / -direction.z() : 9.0;
        const double length_m = std::min(9.0, to_ground_m);
        const auto found = sweep.first_contact(centre_m, direction, length_m);
        const auto expected = first_touch_of_all(cover, centre_m, direction, length_m, radius_m);
        RC_ASSERT(found.has_value() == expected.has_value());
        if (found) {
            RC_ASSERT(std::abs(found->along_m - *expected) < 1e-9);
            RC_ASSERT(std::abs(found->towards.norm() - 1.0) < 1e-9);
        }
    }
}

}  // namespace
}  // namespace rockfall::throws_test
