#include "coupling/assessments/nets/siting/stretches.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

namespace coupling::siting::stretches_test {
namespace {

LineArrival at(double along_m, double energy_kj) {
    return {along_m, energy_kj};
}

double energy_in(const std::vector<LineBin>& bins, const std::vector<Stretch>& stretches) {
    double sum = 0.0;
    for (const LineBin& bin : bins) {
        const bool inside = std::any_of(stretches.begin(), stretches.end(), [&](const Stretch& s) {
            return bin.from_m >= s.from_m && bin.to_m <= s.to_m;
        });
        sum += inside ? bin.energy_sum_kj : 0.0;
    }
    return sum;
}

TEST(BinsAlong, HoldEachRockOnceAndEndWithTheLine) {
    const std::vector<LineArrival> arrivals{at(0.0, 1.0), at(9.9, 2.0), at(10.0, 4.0), at(25.0, 8.0),
                                            at(25.4, 16.0)};
    const std::vector<LineBin> bins = bins_along(25.3, arrivals);
    ASSERT_EQ(bins.size(), 3U);
    EXPECT_EQ(bins[0].rocks, 2U);
    EXPECT_EQ(bins[1].energy_sum_kj, 4.0);
    EXPECT_EQ(bins[2].rocks, 2U);  // a hair beyond the end belongs to the last
    EXPECT_EQ(bins[2].to_m, 25.3);
}

TEST(NeededStretches, AreWhereTheEnergyComes) {
    const std::vector<LineArrival> arrivals{at(5.0, 1.0), at(35.0, 50.0), at(45.0, 48.0), at(95.0, 1.0)};
    const auto bins = bins_along(100.0, arrivals);
    EXPECT_EQ(needed_stretches(bins, 0.95), (std::vector<Stretch>{{30.0, 50.0}}));
    EXPECT_EQ(needed_stretches(bins, 0.5), (std::vector<Stretch>{{30.0, 40.0}}));
}

TEST(NeededStretches, BecomeOneAcrossASmallGap) {
    const std::vector<LineArrival> near{at(5.0, 10.0), at(35.0, 10.0)};
    EXPECT_EQ(needed_stretches(bins_along(100.0, near), 0.99), (std::vector<Stretch>{{0.0, 40.0}}));
    const std::vector<LineArrival> apart{at(5.0, 10.0), at(45.0, 10.0)};
    EXPECT_EQ(needed_stretches(bins_along(100.0, apart), 0.99),
              (std::vector<Stretch>{{0.0, 10.0}, {40.0, 50.0}}));
}

TEST(NeededStretches, AreNoneWhereNothingComes) {
    EXPECT_TRUE(needed_stretches(bins_along(100.0, {}), 0.95).empty());
}

RC_GTEST_PROP(NeededStretches, ReceiveTheWantedShare, (const std::vector<std::uint16_t>& places)) {
    std::vector<LineArrival> arrivals;
    for (const std::uint16_t place : places) {
        arrivals.push_back(at(place % 500, 1.0 + place % 37));
    }
    const auto bins = bins_along(500.0, arrivals);
    const double all = std::accumulate(bins.begin(), bins.end(), 0.0,
                                       [](double sum, const LineBin& b) { return sum + b.energy_sum_kj; });
    const std::vector<Stretch> stretches = needed_stretches(bins, 0.9);
    RC_ASSERT(energy_in(bins, stretches) >= 0.9 * all - 1e-9);
    for (std::size_t i = 1; i < stretches.size(); ++i) {
        RC_ASSERT(stretches[i].from_m - stretches[i - 1].to_m > joined_gap_m);
    }
}

}  // namespace
}  // namespace coupling::siting::stretches_test
