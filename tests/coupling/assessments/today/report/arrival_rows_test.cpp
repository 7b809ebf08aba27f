#include "coupling/assessments/today/report/arrival_rows.hpp"

#include <gtest/gtest.h>

namespace coupling::report::arrival_rows_test {
namespace {

rockfall::TargetTally tally_of(int bare, int forest) {
    rockfall::TargetTally tally;
    const rockfall::Arrival arrival{.reached = true, .energy_j = 5e4F, .speed_mps = 10.0F, .height_m = 1.0F};
    for (int rock = 0; rock < bare; ++rock) {
        tally.by_cover[static_cast<std::size_t>(rockfall::Cover::bare)].add(arrival);
    }
    for (int rock = 0; rock < forest; ++rock) {
        tally.by_cover[static_cast<std::size_t>(rockfall::Cover::forest)].add(arrival);
    }
    tally.reached_both = static_cast<std::uint64_t>(forest);
    return tally;
}

std::string cells(int bare, int forest) {
    PageFields fields = arrival_cells(tally_of(bare, forest), 1000);
    fields.push_back({"with_forest", true});
    return filled_template("arrival_cells.html", fields);
}

TEST(ArrivalRows, GiveTheLowerLimitWhereNoRockComesThrough) {
    // One-sided: 1 - (0.05^(-1/20) - 1) = 0.838.
    EXPECT_NE(cells(20, 0).find("<td>100.0\u00a0% <span class=\"soft\">(84 to 100)</span></td>"),
              std::string::npos)
        << cells(20, 0);
}

TEST(ArrivalRows, SayNothingOfFewRocks) {
    EXPECT_NE(cells(3, 1).find("<td>–</td>"), std::string::npos) << cells(3, 1);
    EXPECT_EQ(cells(20, 10).find("<td>–</td>"), std::string::npos) << cells(20, 10);
}

}  // namespace
}  // namespace coupling::report::arrival_rows_test
