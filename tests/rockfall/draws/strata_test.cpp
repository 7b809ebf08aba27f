#include "rockfall/draws/strata.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace rockfall::strata_test {
namespace {

TEST(Strata, AreAsManyAsTheRocksAllow) {
    EXPECT_EQ(strata_for(20), 16U);
    EXPECT_EQ(strata_for(511), 16U);
    EXPECT_EQ(strata_for(512), 32U);
    EXPECT_EQ(strata_for(1024), 64U);
    EXPECT_EQ(strata_for(1'000'000), 64U);
}

TEST(Strata, HaveOneOfEachOfTheRocksThatFollowOneAnother) {
    for (const std::uint32_t strata : {16U, 32U, 64U}) {
        for (std::uint64_t group = 0; group < 200; ++group) {
            std::set<std::uint32_t> found;
            for (std::uint64_t rock = group * strata; rock < (group + 1) * strata; ++rock) {
                found.insert(stratum_of(rock, strata, 5));
            }
            EXPECT_EQ(found.size(), strata);
            EXPECT_LT(*found.rbegin(), strata);
        }
    }
}

TEST(Strata, DoNotGoWithThePlaceInAGroup) {
    // Each place of a group is in each stratum equally often: chi-square of 64 strata within 5 deviations.
    constexpr std::uint32_t strata = 64;
    constexpr std::uint64_t groups = 6400;
    for (const std::uint64_t place : {0U, 1U, 31U, 63U}) {
        std::vector<double> counts(strata);
        for (std::uint64_t group = 0; group < groups; ++group) {
            counts[stratum_of(group * strata + place, strata, 11)] += 1.0;
        }
        double chi_square = 0.0;
        for (const double count : counts) {
            chi_square += (count - 100.0) * (count - 100.0) / 100.0;
        }
        EXPECT_LT(chi_square, 63.0 + 5.0 * std::sqrt(2.0 * 63.0)) << place;
    }
}

}  // namespace
}  // namespace rockfall::strata_test
