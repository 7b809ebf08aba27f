#include "rockfall/tally/ensemble_tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockfall::ensemble_tally_test {
namespace {

Arrival with_energy(float energy_j) {
    return {true, false, 0.0F, 0.0F, energy_j, energy_j, 10.0F, 1.0F};
}

TEST(ArrivalTally, CountsEnergiesFromALimitOn) {
    ArrivalTally tally;
    for (const float limit_j : counted_energies_j) {
        tally.add(with_energy(limit_j));
    }
    EXPECT_EQ(tally.above, (std::array<std::uint64_t, 4>{4, 3, 2, 1})) << "as in cells: CellReleases";
    for (const float limit_j : counted_energies_j) {
        tally.add(with_energy(std::nextafter(limit_j, 0.0F)));
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

RockRecord with_run_out(double run_out_m, StopReason reason, RimPart left_over = RimPart::north) {
    RockRecord record;
    record.end_m.x() = run_out_m;
    record.reason = reason;
    record.left_over = left_over;
    return record;
}

TEST(RunTally, KeepsRocksThatDidNotStopOutOfTheRunOut) {
    RunTally first;
    RunTally second;
    first.add(with_run_out(15.0, StopReason::at_rest));
    first.add(with_run_out(95.0, StopReason::left_terrain, RimPart::south));
    second.add(with_run_out(25.0, StopReason::tree));
    second.add(with_run_out(85.0, StopReason::left_terrain, hole_part(3)));
    second.add(with_run_out(75.0, StopReason::left_terrain, RimPart::south));
    second.add(with_run_out(65.0, StopReason::gave_up));
    first.add(second);
    EXPECT_EQ(first.rocks, 6U);
    EXPECT_EQ(first.stopped(), 2U);
    EXPECT_EQ(first.run_out_sum_mm, 40'000U);
    EXPECT_EQ(first.open_run_out_sum_mm, 320'000U);
    EXPECT_EQ(first.run_out[1] + first.run_out[2], 2U);
    EXPECT_EQ(first.run_out[9], 0U);
    EXPECT_EQ(first.open_run_out[9], 1U);
    EXPECT_DOUBLE_EQ(first.max_run_out_m, 25.0);
    EXPECT_DOUBLE_EQ(first.max_open_run_out_m, 95.0);
    EXPECT_EQ(first.left_over, (std::map<RimPart, std::uint64_t>{{RimPart::south, 2}, {hole_part(3), 1}}));
}

}  // namespace
}  // namespace rockfall::ensemble_tally_test
