#include "coupling/results/report/map/rebin.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace coupling::report::rebin_test {
namespace {

using rockfall::fine_energy_bins;

std::vector<std::uint64_t> counts_of(std::initializer_list<float> energies_j) {
    std::vector<std::uint64_t> counts(fine_energy_bins.count());
    for (const float energy_j : energies_j) {
        ++counts[fine_energy_bins.bin_of(energy_j)];
    }
    return counts;
}

TEST(Rebinned, LosesNoRock) {
    const std::vector<double> edges{1.0, 10.0, 100.0};
    const std::vector<double> bars =
        rebinned(fine_energy_bins, counts_of({5.0F, 900.0F, 20000.0F, 30000.0F, 5e6F, 2e9F}), 1000.0, edges);
    EXPECT_DOUBLE_EQ(std::accumulate(bars.begin(), bars.end(), 0.0), 6.0);
    EXPECT_DOUBLE_EQ(bars[0], 2.0) << "the first bar takes all below";
    EXPECT_DOUBLE_EQ(bars[1], 4.0) << "the last all above";
}

TEST(Rebinned, SharesABinThatAnEdgeCuts) {
    const std::size_t bin = fine_energy_bins.bin_of(50000.0F);
    const double middle = 0.5 * (fine_energy_bins.low_of(bin) + fine_energy_bins.high_of(bin));
    const std::vector<double> edges{1.0, middle, 1e6};
    const std::vector<double> bars = rebinned(fine_energy_bins, counts_of({50000.0F}), 1.0, edges);
    EXPECT_NEAR(bars[0], 0.5, 1e-9);
    EXPECT_NEAR(bars[1], 0.5, 1e-9);
}

TEST(Exceeded, FallsFromAllToNone) {
    const auto curve = exceeded(fine_energy_bins, counts_of({1000.0F, 2000.0F, 2000.0F}));
    ASSERT_FALSE(curve.empty());
    EXPECT_EQ(curve.front().second, 3.0);
    EXPECT_EQ(curve.back().second, 0.0);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        EXPECT_GE(curve[i].first, curve[i - 1].first);
        EXPECT_LE(curve[i].second, curve[i - 1].second);
    }
}

TEST(Exceeded, OfNothingIsNothing) {
    EXPECT_TRUE(exceeded(fine_energy_bins, counts_of({})).empty());
}

}  // namespace
}  // namespace coupling::report::rebin_test
