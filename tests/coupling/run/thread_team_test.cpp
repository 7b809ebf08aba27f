#include "coupling/run/thread_team.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace coupling::thread_team_test {
namespace {

TEST(ThreadTeam, DoesEachPieceOfEachRoundOnce) {
    for (const int threads : {1, 2, 5}) {
        ThreadTeam team{threads};
        std::vector<std::atomic<int>> done(300);
        constexpr int rounds = 3000;
        int expected_of_first = 0;
        for (int round = 0; round < rounds; ++round) {
            const std::size_t count = static_cast<std::size_t>(round) % done.size();
            team.for_each(count, [&](std::size_t i) { ++done[i]; });
            expected_of_first += count > 0 ? 1 : 0;
            ASSERT_EQ(done[0], expected_of_first) << "all are done when for_each returns";
        }
        for (std::size_t i = 0; i < done.size(); ++i) {
            EXPECT_EQ(done[i], rounds / 300 * static_cast<int>(done.size() - 1 - i)) << threads << " " << i;
        }
    }
}

TEST(ThreadTeam, ThrowsWhatAPieceThrowsAndGoesOn) {
    ThreadTeam team{3};
    EXPECT_THROW(team.for_each(50,
                               [](std::size_t i) {
                                   if (i == 7) {
                                       throw std::runtime_error{"seven"};
                                   }
                               }),
                 std::runtime_error);
    std::atomic<int> done{0};
    team.for_each(50, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 50);
}

}  // namespace
}  // namespace coupling::thread_team_test
