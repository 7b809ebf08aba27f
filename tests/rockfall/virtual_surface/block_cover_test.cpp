#include "rockfall/virtual_surface/block_cover.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace rockfall::block_cover_test {
namespace {

/// Distance of two blocks in plan, over the border where that is shorter.
double apart_m(const Block& a, const Block& b, double side_m) {
    const double dx_m = std::remainder(a.x_m - b.x_m, side_m);
    const double dy_m = std::remainder(a.y_m - b.y_m, side_m);
    return std::sqrt(dx_m * dx_m + dy_m * dy_m);
}

BlockKind kind_of(double low_m, double high_m, double cover, double gathering = 0.0) {
    BlockKind kind;
    kind.low_m = low_m;
    kind.high_m = high_m;
    kind.cover = cover;
    kind.burial = 0.0;
    kind.gathering = gathering;
    return kind;
}

BlockCover laid(const BlockKind& kind, std::uint32_t number = 0, double side_m = default_patch_m) {
    return lay_blocks(std::array{kind}, side_m, {5, number});
}

/// Share of blocks that touch another.
double share_in_touch(const BlockCover& cover) {
    double in_touch = 0.0;
    for (const Block& block : cover.blocks()) {
        for (const Block& other : cover.blocks()) {
            const double gap_m = apart_m(block, other, cover.side_m()) - block.radius_m - other.radius_m;
            if (&block != &other && gap_m < 1e-6) {
                in_touch += 1.0;
                break;
            }
        }
    }
    return in_touch / static_cast<double>(cover.blocks().size());
}

TEST(BlockCover, RefusesABlockThatOverlapsAcrossTheBorder) {
    BlockCover cover{10.0, 1.0};
    EXPECT_TRUE(cover.add({9.9, 5.0, 0.5, 0.5}));
    EXPECT_FALSE(cover.add({0.5, 5.0, 0.5, 0.5}));
    EXPECT_FALSE(cover.add({-0.5, 4.5, 0.5, 0.5}));
    EXPECT_TRUE(cover.add({10.9, 5.0, 0.5, 0.5}));  // just in touch, at 0.9
    EXPECT_NEAR(cover.blocks()[1].x_m, 0.9, 1e-12);
    EXPECT_NEAR(cover.cover(), 2.0 * std::numbers::pi * 0.25 / 100.0, 1e-15);
}

TEST(BlockCover, CountsCellsOnOverTheBorder) {
    BlockCover cover{10.0, 1.0};
    cover.add({9.5, 0.5, 0.5, 0.5});
    for (const std::int64_t patch : {-3, -1, 0, 2}) {
        const BlockCover::Cell cell = cover.cell(9 + 10 * patch, -10 * patch);
        ASSERT_EQ(cell.blocks.size(), 1U) << patch;
        EXPECT_DOUBLE_EQ(cell.shift_x_m, 10.0 * static_cast<double>(patch));
        EXPECT_DOUBLE_EQ(cell.shift_y_m, -10.0 * static_cast<double>(patch));
    }
}

TEST(BlockCover, WeighsProjectionByPlanArea) {
    BlockCover cover{10.0, 1.0};
    cover.add({2.0, 2.0, 0.5, 0.5});
    cover.add({5.0, 5.0, 0.0, 0.25});
    EXPECT_NEAR(cover.mean_projection_m(), (1.0 * 0.25 + 0.25 * 0.0625) / 0.3125, 1e-12);
    EXPECT_EQ(cover.highest_m(), 1.0);
}

TEST(LayBlocks, BuriesTheStatedShareOfTheDiameter) {
    BlockKind kind = kind_of(0.4, 0.8, 0.1);
    kind.burial = 0.3;
    const BlockCover cover = laid(kind);
    for (const Block& block : cover.blocks()) {
        EXPECT_NEAR((2.0 * block.radius_m - block.top_m()) / (2.0 * block.radius_m), 0.3, 1e-12);
    }
}

TEST(LayBlocks, MeetsTheStatedCoverOnAverage) {
    // Sparse enough that one block is an eighth of all: laying until the cover is passed would give 6 % too
    // much. The cover of one surface lies within one block of the stated one, so four standard deviations
    // of the mean are at most 4 * 0.5 blocks / sqrt(surfaces).
    constexpr std::uint32_t surfaces = 400;
    const BlockKind kind = kind_of(0.6, 0.8, 0.005);
    const double block_share = std::numbers::pi * 0.16 / (24.0 * 24.0);
    double sum = 0.0;
    for (std::uint32_t number = 0; number < surfaces; ++number) {
        const double cover = laid(kind, number).cover();
        EXPECT_NEAR(cover, kind.cover, block_share);
        sum += cover;
    }
    EXPECT_NEAR(sum / surfaces, kind.cover, 4.0 * 0.5 * block_share / std::sqrt(surfaces));
}

TEST(LayBlocks, DrawsFromObservedDiametersOnly) {
    BlockKind kind = kind_of(0.0, 0.0, 0.2);
    kind.observed_m = {0.3, 0.5, 0.5, 0.9};
    int halves = 0;
    const BlockCover cover = laid(kind);
    for (const Block& block : cover.blocks()) {
        const double diameter_m = 2.0 * block.radius_m;
        EXPECT_TRUE(diameter_m == 0.3 || diameter_m == 0.5 || diameter_m == 0.9) << diameter_m;
        halves += diameter_m == 0.5 ? 1 : 0;
    }
    const auto count = static_cast<double>(cover.blocks().size());
    EXPECT_NEAR(halves / count, 0.5, 4.0 * std::sqrt(0.25 / count));
}

TEST(LayBlocks, GathersBlocksAtPresentOnes) {
    // A block laid at another touches it; one laid anywhere touches none.
    EXPECT_EQ(share_in_touch(laid(kind_of(0.4, 0.8, 0.05, 0.0))), 0.0);
    EXPECT_GT(share_in_touch(laid(kind_of(0.4, 0.8, 0.05, 0.8))), 0.8);
    EXPECT_EQ(share_in_touch(laid(kind_of(0.4, 0.8, 0.05, 1.0))), 1.0);
}

TEST(LayBlocks, LaysSeveralKindsOnOneSurface) {
    const std::array kinds{kind_of(1.0, 1.0, 0.02), kind_of(0.1, 0.1, 0.05)};
    const BlockCover cover = lay_blocks(kinds, default_patch_m, {5, 0});
    double coarse_m2 = 0.0;
    for (const Block& block : cover.blocks()) {
        coarse_m2 += block.radius_m == 0.5 ? block.plan_area_m2() : 0.0;
    }
    EXPECT_NEAR(coarse_m2 / (24.0 * 24.0), 0.02, 0.8 / (24.0 * 24.0));
    EXPECT_NEAR(cover.cover(), 0.07, 0.8 / (24.0 * 24.0));
}

TEST(LayBlocks, EndsWhereNoPlaceIsLeft) {
    // Discs laid one by one jam at 54.7 % (Feder 1980); random looks come near only slowly.
    const BlockCover cover = laid(kind_of(0.8, 0.8, largest_cover));
    EXPECT_GT(cover.cover(), 0.48);
    EXPECT_LT(cover.cover(), 0.547);
}

TEST(LayBlocks, GivesAnotherSurfaceForEachNumberAndSeedAndTheSameAgain) {
    const std::array kinds{kind_of(0.4, 0.8, 0.1, 0.5)};
    const auto first_x_m = [&](const SurfaceKey& key) {
        return lay_blocks(kinds, default_patch_m, key).blocks().front().x_m;
    };
    EXPECT_EQ(first_x_m({5, 0}), first_x_m({5, 0}));
    EXPECT_NE(first_x_m({5, 0}), first_x_m({5, 1}));
    EXPECT_NE(first_x_m({5, 0}), first_x_m({6, 0}));
}

RC_GTEST_PROP(LayBlocks, NeverOverlapInPlanAndCountTheirCoverExactly, ()) {
    const auto per_mille = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
    BlockKind kind;
    kind.low_m = per_mille(100, 800);
    kind.high_m = kind.low_m + per_mille(0, 800);
    kind.cover = per_mille(0, 450);
    kind.burial = per_mille(0, 501);
    kind.gathering = per_mille(0, 1001);
    const double side_m = per_mille(4'000, 12'000);
    const BlockCover cover = lay_blocks(std::array{kind}, side_m, {*rc::gen::arbitrary<std::uint64_t>(), 0});
    double area_m2 = 0.0;
    for (std::size_t i = 0; i < cover.blocks().size(); ++i) {
        const Block& a = cover.blocks()[i];
        area_m2 += std::numbers::pi * a.radius_m * a.radius_m;
        RC_ASSERT((a.x_m >= 0.0 && a.x_m < side_m && a.y_m >= 0.0 && a.y_m < side_m));
        for (std::size_t j = 0; j < i; ++j) {
            const Block& b = cover.blocks()[j];
            RC_ASSERT(apart_m(a, b, side_m) > (a.radius_m + b.radius_m) * (1.0 - 1e-8));
        }
    }
    RC_ASSERT(std::abs(area_m2 / (side_m * side_m) - cover.cover()) < 1e-12);
}

}  // namespace
}  // namespace rockfall::block_cover_test
