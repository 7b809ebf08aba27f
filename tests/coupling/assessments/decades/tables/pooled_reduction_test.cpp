#include "coupling/assessments/decades/tables/pooled_reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/tally/log_bins.hpp"

namespace coupling::decades::pooled_reduction_test {
namespace {

constexpr std::uint16_t bare_bin = 160;
constexpr std::uint16_t forest_bin = bare_bin - 16;  // 16 bins to a doubling: exactly half the energy

/// A replicate in which `both` rocks arrive on both slopes and `only_bare` on the bare one alone, in year 5.
MemberYears replicate_of(std::uint32_t number, std::uint64_t both, std::uint64_t only_bare) {
    MemberYears member;
    member.member = {0, number};
    TargetRow row;
    row.year = 5;
    row.paired = {.both = both, .only_forest = 0, .only_bare = only_bare};
    member.targets.push_back(row);
    const auto bare = static_cast<std::uint32_t>(both + only_bare);
    member.energies.push_back({5, 0, bare_bin, static_cast<std::uint32_t>(Cover::bare), bare});
    member.energies.push_back(
        {5, 0, forest_bin, static_cast<std::uint32_t>(Cover::forest), static_cast<std::uint32_t>(both)});
    return member;
}

struct OneRegime {
    std::vector<std::string> regimes{"none"};
    forest::SpeciesTable species = forest::SpeciesTable::shipped();
    Names names{regimes, {{}}, species};
};

TEST(PooledReduction, IsThatOfAllRocksTogetherWithItsJackknife) {
    const OneRegime one;
    const std::vector<MemberYears> members{replicate_of(0, 20, 20), replicate_of(1, 10, 30),
                                           replicate_of(2, 30, 10)};
    const auto found = pooled_reduction(one.names, members, 0, 0, 5);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->arrivals_bare, 120U);
    EXPECT_EQ(found->arrivals_forest, 60U);
    EXPECT_EQ(found->replicates, 3U);
    // Half as many rocks, each of half the energy: 1 - 0.5 x 0.5.
    EXPECT_NEAR(found->reduction.bari_percent, 50.0, 1e-9);
    EXPECT_NEAR(found->reduction.miri_percent, 50.0, 1e-9);
    EXPECT_NEAR(found->reduction.orpi_percent, 75.0, 1e-9);
    // Without one replicate in turn 40, 50 and 30 of 80 arrive: 75, 68.75 and 81.25 %. Their squares about 75
    // sum to 78.125; error = sqrt(2 / 3 x 78.125) = 7.2169; Student's t with 2 degrees, 95 %: 2.919986.
    EXPECT_NEAR(found->orpi_90.low, 75.0 - 2.919986 * 7.216878, 1e-4);
    EXPECT_NEAR(found->orpi_90.high, 75.0 + 2.919986 * 7.216878, 1e-4);
}

TEST(PooledReduction, IsNotKnownWhereNothingArrivesOrTooFewDo) {
    const OneRegime one;
    std::vector<MemberYears> members{replicate_of(0, 0, 0), replicate_of(1, 0, 0), replicate_of(2, 0, 0)};
    EXPECT_FALSE(pooled_reduction(one.names, members, 0, 0, 5));
    EXPECT_FALSE(pooled_reduction(one.names, members, 0, 0, 6)) << "a year without rocks";

    // 18 rocks through the forest have no 95th percentile; 20 have one.
    members = {replicate_of(0, 6, 10), replicate_of(1, 6, 10), replicate_of(2, 6, 10)};
    const auto few = pooled_reduction(one.names, members, 0, 0, 5);
    ASSERT_TRUE(few);
    EXPECT_NEAR(few->reduction.bari_percent, 62.5, 1e-9);
    EXPECT_TRUE(std::isnan(few->reduction.miri_percent));
    EXPECT_TRUE(std::isnan(few->reduction.orpi_percent));
    EXPECT_TRUE(std::isnan(few->orpi_90.low));
}

TEST(PooledReduction, HasNoIntervalOfTwoReplicates) {
    const OneRegime one;
    const std::vector<MemberYears> two{replicate_of(0, 20, 20), replicate_of(1, 30, 10)};
    const auto found = pooled_reduction(one.names, two, 0, 0, 5);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->reduction.bari_percent, 37.5, 1e-9);
    EXPECT_TRUE(std::isnan(found->orpi_90.low));
    EXPECT_TRUE(std::isnan(found->orpi_90.high));
}

}  // namespace
}  // namespace coupling::decades::pooled_reduction_test
