#include "coupling/assessments/decades/tables/variance_split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coupling::decades::variance_split_test {
namespace {

MemberYears replicate_of(std::uint32_t number, std::uint64_t both, std::uint64_t only_bare) {
    MemberYears member;
    member.member = {0, number};
    TargetRow row;
    row.year = 5;
    row.paired = {.both = both, .only_forest = 0, .only_bare = only_bare};
    member.targets.push_back(row);
    return member;
}

struct OneRegime {
    std::vector<std::string> regimes{"none"};
    forest::SpeciesTable species = forest::SpeciesTable::shipped();
    Names names{regimes, {{}}, species};
};

TEST(VarianceSplit, IsAsByHand) {
    const OneRegime one;
    // 100 rocks each; 10, 20 and 30 come through: protection 90, 80, 70 %, variance 100. Of all 20 % come
    // through: 100^2 x 0.2 x 0.8 / 100 = 16 within a replicate.
    const std::vector<MemberYears> members{replicate_of(0, 10, 90), replicate_of(1, 20, 80),
                                           replicate_of(2, 30, 70)};
    const auto split = variance_split(one.names, members, 0, 0, 5);
    ASSERT_TRUE(split);
    EXPECT_EQ(split->replicates, 3U);
    EXPECT_NEAR(split->between, 100.0, 1e-9);
    EXPECT_NEAR(split->rocks, 16.0, 1e-9);
    EXPECT_NEAR(split->forest, 84.0, 1e-9);
    EXPECT_FALSE(variance_split(one.names, members, 0, 0, 6)) << "a year without rocks";
    EXPECT_FALSE(variance_split(one.names, std::vector{members[0]}, 0, 0, 5)) << "one replicate";

    // Equal replicates: nothing is left for the forest.
    const std::vector<MemberYears> equal{replicate_of(0, 20, 80), replicate_of(1, 20, 80)};
    EXPECT_EQ(variance_split(one.names, equal, 0, 0, 5)->between, 0.0);
    EXPECT_EQ(variance_split(one.names, equal, 0, 0, 5)->forest, 0.0);
}

TEST(VarianceSplit, FindsTheForestsVarianceInDraws) {
    const OneRegime one;
    // Forests let 10 or 20 % through, half of the replicates each: variance 25 in percent points; 300 rocks.
    std::mt19937_64 random{1};
    std::vector<MemberYears> members;
    constexpr std::uint32_t replicates = 2000;
    constexpr int rocks = 300;
    for (std::uint32_t r = 0; r < replicates; ++r) {
        std::binomial_distribution<int> through{rocks, r % 2 == 0 ? 0.1 : 0.2};
        const int both = through(random);
        members.push_back(
            replicate_of(r, static_cast<std::uint64_t>(both), static_cast<std::uint64_t>(rocks - both)));
    }
    const auto split = variance_split(one.names, members, 0, 0, 5);
    ASSERT_TRUE(split);
    // Rocks: the mean of 0.09 and 0.16 over 300, 4.17; by the pooled share 0.15 x 0.85 / 300, 4.25. The error
    // of a variance of about 29 over 2000 draws is 29 sqrt(2 / 2000) = 0.93: four of them.
    EXPECT_NEAR(split->rocks, 4.25, 0.2);
    EXPECT_NEAR(split->forest, 25.0, 3.8);
}

}  // namespace
}  // namespace coupling::decades::variance_split_test
