#include "coupling/exchange/impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::exchange::impacts_test {
namespace {

std::vector<RockHit> one_hit_each(std::uint64_t rocks) {
    std::vector<RockHit> hits(rocks);
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        hits[rock].rock = rock;
        hits[rock].impact.tree = forest::TreeId{rock};
    }
    return hits;
}

TEST(Impacts, AreOfTheShareOfRocksThatReallyFall) {
    constexpr std::uint64_t rocks = 20'000;
    constexpr double share = 0.3;
    const std::vector<RockHit> hits = one_hit_each(rocks);
    const auto found = static_cast<double>(impacts_of(hits, {share, 1, 0, 5}).size());
    const double four_sigma = 4.0 * std::sqrt(rocks * share * (1.0 - share));
    EXPECT_NEAR(found, rocks * share, four_sigma);
    EXPECT_TRUE(impacts_of(hits, {0.0, 1, 0, 5}).empty());
    EXPECT_EQ(impacts_of(hits, {1.0, 1, 0, 5}).size(), hits.size());
}

TEST(Impacts, OfARockDependOnItsNumberAlone) {
    const std::vector<RockHit> all = one_hit_each(1000);
    const std::vector<RockHit> second_half{all.begin() + 500, all.end()};
    std::vector<forest::TreeId> expected;
    for (const forest::Impact& impact : impacts_of(all, {0.5, 1, 0, 5})) {
        if (forest::number_of(impact.tree) >= 500) {
            expected.push_back(impact.tree);
        }
    }
    std::vector<forest::TreeId> found;
    for (const forest::Impact& impact : impacts_of(second_half, {0.5, 1, 0, 5})) {
        found.push_back(impact.tree);
    }
    EXPECT_EQ(found, expected);
}

TEST(Impacts, KeepAllHitsOfARealRockInTheirOrder) {
    std::vector<RockHit> hits;
    for (std::uint64_t hit = 0; hit < 6; ++hit) {
        hits.push_back({7, {.tree = forest::TreeId{hit}}});
    }
    std::size_t real = 0;
    for (std::int32_t year = 0; year < 50; ++year) {
        const std::vector<forest::Impact> impacts = impacts_of(hits, {0.5, 1, 0, year});
        ASSERT_TRUE(impacts.empty() || impacts.size() == hits.size()) << year;
        for (std::size_t i = 0; i < impacts.size(); ++i) {
            EXPECT_EQ(impacts[i].tree, hits[i].impact.tree);
        }
        real += impacts.empty() ? 0 : 1;
    }
    EXPECT_GT(real, 0U);
    EXPECT_LT(real, 50U);
}

}  // namespace
}  // namespace coupling::exchange::impacts_test
