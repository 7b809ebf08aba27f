// Stopping probabilities of virtual surfaces against a table made earlier with another program (isolated and
// gathered spheres on a patch of 24 m, first contact decides). That program threw 16 000 rocks at four
// surfaces for each figure, 2000 at one surface of fine debris, and printed tenths of a per cent; its own
// error is in the tolerance.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "rockfall/virtual_surface/estimate.hpp"

namespace rockfall::published_table_test {
namespace {

constexpr std::uint32_t surfaces = 32;
constexpr std::uint32_t throws = 3000;

struct Row {
    double low_m;
    double high_m;
    double rock_m;
    std::array<double, 7> percent;  ///< at the covers below
};

constexpr std::array covers{0.01, 0.02, 0.05, 0.10, 0.20, 0.30, 0.50};

constexpr std::array<Row, 9> isolated{{{0.08, 0.10, 0.30, {0.8, 1.9, 2.8, 1.7, 0.3, 0.1, 0.0}},
                                       {0.08, 0.10, 0.95, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}},
                                       {0.20, 0.40, 0.50, {2.4, 4.2, 8.2, 10.1, 6.8, 3.0, 1.2}},
                                       {0.20, 0.40, 0.95, {1.2, 1.8, 3.3, 2.6, 0.7, 0.1, 0.0}},
                                       {0.40, 0.80, 0.50, {2.9, 5.1, 10.8, 15.8, 15.9, 11.7, 7.6}},
                                       {0.40, 0.80, 0.95, {2.5, 4.5, 9.2, 10.2, 7.4, 3.2, 1.1}},
                                       {0.40, 0.80, 1.84, {1.2, 2.1, 3.3, 3.4, 1.0, 0.0, 0.0}},
                                       {0.80, 1.20, 0.95, {3.0, 5.8, 11.0, 15.0, 13.3, 8.1, 3.6}},
                                       {0.80, 1.20, 1.84, {2.4, 4.4, 8.2, 8.0, 5.1, 1.1, 0.2}}}};

struct Variant {
    double gathering;
    double burial;
    std::array<double, 6> percent;  ///< at the covers below; blocks of 0.4-0.8 m, rock of 0.95 m
};

constexpr std::array variant_covers{0.02, 0.05, 0.10, 0.20, 0.30, 0.40};

constexpr std::array<Variant, 3> variants{{{0.8, 0.00, {2.3, 5.4, 8.0, 9.0, 6.3, 3.7}},
                                           {0.0, 0.25, {2.3, 4.5, 5.8, 4.9, 2.5, 0.6}},
                                           {0.0, 0.50, {0.2, 0.5, 0.9, 1.0, 0.6, 0.3}}}};

/// Sampling of the table that is compared with.
struct Sampling {
    double surfaces = 4.0;
    double throws = 16'000.0;
};

std::vector<ThrowTally> tallies_of(const BlockKind& kind, double rock_m, std::uint32_t count,
                                   const LayingEffort& effort) {
    std::vector<ThrowTally> tallies;
    for (std::uint32_t number = 0; number < count; ++number) {
        const SurfaceKey key{7, number};
        tallies.push_back(
            throw_rocks(lay_blocks(std::array{kind}, default_patch_m, key, effort), rock_m, {}, key, throws));
    }
    return tallies;
}

/// Expects a figure of the table within three standard errors: ours, that of its surfaces and throws, and
/// that of rounding to tenths of a per cent.
void expect_figure(double percent, const BlockKind& kind, double rock_m, const Sampling& theirs,
                   std::uint32_t count, const LayingEffort& effort = {}) {
    const SurfaceEstimate ours = stop_probability(tallies_of(kind, rock_m, count, effort));
    const double p = ours.value;
    const double ours2 = ours.standard_error * ours.standard_error;
    const double between = std::max(0.0, ours2 * count - p * (1.0 - p) / throws);
    const double theirs2 = between / theirs.surfaces + p * (1.0 - p) / theirs.throws;
    const double rounding2 = 0.001 * 0.001 / 12.0;
    EXPECT_NEAR(p, percent / 100.0, 3.0 * std::sqrt(ours2 + theirs2 + rounding2))
        << "blocks " << kind.low_m << "-" << kind.high_m << " m, rock " << rock_m << " m, cover "
        << kind.cover << ", burial " << kind.burial << ", gathering " << kind.gathering;
}

BlockKind kind_of(double low_m, double high_m, double cover) {
    BlockKind kind;
    kind.low_m = low_m;
    kind.high_m = high_m;
    kind.cover = cover;
    kind.burial = 0.0;
    return kind;
}

TEST(StopProbability, OfFineDebrisIsThatOfTheTable) {
    for (const Row& row : {isolated[0], isolated[1]}) {
        for (std::size_t i = 0; i + 1 < covers.size(); ++i) {
            expect_figure(row.percent[i], kind_of(row.low_m, row.high_m, covers[i]), row.rock_m,
                          {1.0, 2000.0}, 4);
        }
    }
}

TEST(StopProbability, OfCoarserBlocksIsThatOfTheTable) {
    for (std::size_t r = 2; r < isolated.size(); ++r) {
        const Row& row = isolated[r];
        for (std::size_t i = 0; i + 1 < covers.size(); ++i) {
            expect_figure(row.percent[i], kind_of(row.low_m, row.high_m, covers[i]), row.rock_m, {},
                          surfaces);
        }
    }
}

TEST(StopProbability, AtHalfCoverIsThatOfTheTableWhereLayingGivesUpAsEarly) {
    // The column of 50 % belongs to surfaces that were given up after a block had looked 200 times for a
    // place, at covers of 38 to 42 %. Looking on reaches 47 to 50 % and lower probabilities.
    const LayingEffort early{.looks_at_others = 200, .looks_anywhere = 0};
    for (std::size_t r = 0; r < isolated.size(); ++r) {
        const Row& row = isolated[r];
        const bool fine = r < 2;
        expect_figure(row.percent[6], kind_of(row.low_m, row.high_m, covers[6]), row.rock_m,
                      fine ? Sampling{1.0, 2000.0} : Sampling{}, fine ? 4 : surfaces, early);
    }
    const BlockCover given_up =
        lay_blocks(std::array{kind_of(0.4, 0.8, 0.5)}, default_patch_m, {7, 0}, early);
    EXPECT_LT(given_up.cover(), 0.44);
    EXPECT_GT(lay_blocks(std::array{kind_of(0.4, 0.8, 0.5)}, default_patch_m, {7, 0}).cover(), 0.45);
}

TEST(StopProbability, OfGatheredAndBuriedBlocksIsThatOfTheTable) {
    for (const Variant& variant : variants) {
        for (std::size_t i = 0; i < variant_covers.size(); ++i) {
            BlockKind kind = kind_of(0.4, 0.8, variant_covers[i]);
            kind.gathering = variant.gathering;
            kind.burial = variant.burial;
            expect_figure(variant.percent[i], kind, 0.95, {}, 3 * surfaces);
        }
    }
}

TEST(StopProbability, RisesWithCoverAndFallsAgain) {
    const auto at = [](double cover) {
        return stop_probability(tallies_of(kind_of(0.4, 0.8, cover), 0.95, 8, {}));
    };
    const SurfaceEstimate sparse = at(0.02);
    const SurfaceEstimate middle = at(0.10);
    const SurfaceEstimate dense = at(0.40);
    const auto clearly = [](const SurfaceEstimate& more, const SurfaceEstimate& less) {
        return more.value - less.value > 5.0 * std::hypot(more.standard_error, less.standard_error);
    };
    EXPECT_TRUE(clearly(middle, sparse));
    EXPECT_TRUE(clearly(middle, dense));
}

}  // namespace
}  // namespace rockfall::published_table_test
