#include "rockfall/tally/cell_quantile.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rockfall::cell_quantile_test {
namespace {

RC_GTEST_PROP(CellQuantile, IsThatOfTheBinsToTheLastBit, (const std::vector<std::uint16_t>& values)) {
    std::vector<std::uint32_t> counts(energy_bins.count(), 0);
    std::uint64_t total = 0;
    float largest = 0.0F;
    for (const std::uint16_t value : values) {
        const float energy_j = 20.0F * static_cast<float>(value);
        counts[energy_bins.bin_of(energy_j)] += 1U + value / 7U;
        total += 1U + value / 7U;
        largest = std::max(largest, energy_j);
    }
    for (const double share : {0.1, 0.5, 0.9, 0.95, 0.98, 0.99, 1.0}) {
        RC_ASSERT(cell_quantile(energy_bins, counts, total, largest, share) ==
                  quantile(energy_bins, std::span<const std::uint32_t>{counts}, share));
    }
}

TEST(CellQuantile, OfNothingIsNothing) {
    EXPECT_EQ(cell_quantile(height_bins, {}, 0, 0.0F, 0.95), 0.0);
    const std::vector<std::uint32_t> none(height_bins.count(), 0);
    EXPECT_EQ(cell_quantile(height_bins, none, 0, 0.0F, 0.95), 0.0);
}

}  // namespace
}  // namespace rockfall::cell_quantile_test
