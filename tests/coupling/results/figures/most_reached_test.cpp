#include "coupling/results/figures/most_reached.hpp"

#include <gtest/gtest.h>

namespace coupling::most_reached_test {
namespace {

std::vector<rockfall::TargetTally> reached_over_bare_slope(const std::vector<std::uint64_t>& rocks) {
    std::vector<rockfall::TargetTally> tallies(rocks.size());
    for (std::size_t i = 0; i < rocks.size(); ++i) {
        tallies[i].by_cover[static_cast<std::size_t>(rockfall::Cover::bare)].reached = rocks[i];
    }
    return tallies;
}

using Targets = std::vector<std::size_t>;

TEST(MostReached, NamesTheMostReachedFirst) {
    EXPECT_EQ(most_reached(reached_over_bare_slope({3, 0, 9, 4, 9}), 3), (Targets{2, 4, 3}));
}

TEST(MostReached, LeavesAsManyAsThereIsRoomForInTheirOrder) {
    EXPECT_EQ(most_reached(reached_over_bare_slope({3, 0, 9}), 3), (Targets{0, 1, 2}));
    EXPECT_EQ(most_reached(reached_over_bare_slope({}), 3), Targets{});
}

TEST(MostReached, ChoosesAmongSome) {
    EXPECT_EQ(most_reached(reached_over_bare_slope({3, 0, 9, 4}), {0, 1, 3}, 2), (Targets{3, 0}));
}

}  // namespace
}  // namespace coupling::most_reached_test
