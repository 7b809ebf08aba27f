#include "rockfall/tally/ensemble_tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockfall::ensemble_tally_test {
namespace {

Arrival with_energy(float energy_j) {
    return {true, 0.0F, 0.0F, energy_j, energy_j, 10.0F, 1.0F};
}

TEST(ArrivalTally, CountsOnlyEnergiesAboveALimit) {
    ArrivalTally tally;
    for (const float limit_j : counted_energies_j) {
        tally.add(with_energy(limit_j));
    }
    EXPECT_EQ(tally.above, (std::array<std::uint64_t, 4>{3, 2, 1, 0})) << "the limit itself is not above it";
    for (const float limit_j : counted_energies_j) {
        tally.add(with_energy(std::nextafter(limit_j, 2.0F * limit_j)));
    }
    EXPECT_EQ(tally.above, (std::array<std::uint64_t, 4>{7, 5, 3, 1}));
}

TEST(ArrivalTally, AddsUpRocksAboveLimits) {
    ArrivalTally first;
    ArrivalTally second;
    first.add(with_energy(50e3F));
    second.add(with_energy(500e3F));
    second.add(Arrival{});  // a rock that does not arrive
    first.add(second);
    EXPECT_EQ(first.reached, 2U);
    EXPECT_EQ(first.above, (std::array<std::uint64_t, 4>{2, 1, 1, 0}));
}

}  // namespace
}  // namespace rockfall::ensemble_tally_test
