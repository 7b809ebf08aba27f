#include "coupling/assessments/decades/members/starts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <thread>

namespace coupling::decades::starts_test {
namespace {

Start any_start() {
    return {forest::Stand{forest::PatchGrid{{1, 1, 0.0, 0.0, 10.0, 10.0}, {}}, 1, {}, 2000}, {}};
}

TEST(Starts, AreMadeOnceWhoeverAsks) {
    Starts starts{4};
    std::atomic<int> made = 0;
    const auto make = [&] {
        ++made;
        return any_start();
    };
    std::vector<std::thread> askers;
    for (int i = 0; i < 8; ++i) {
        askers.emplace_back(
            [&, i] { EXPECT_NE(starts.of(static_cast<std::uint32_t>(i % 2), make), nullptr); });
    }
    for (std::thread& asker : askers) {
        asker.join();
    }
    EXPECT_EQ(made, 2);
}

TEST(Starts, AreForgottenWhenOthersAreUnderWay) {
    Starts starts{2};
    int made = 0;
    const auto make = [&] {
        ++made;
        return any_start();
    };
    const std::weak_ptr<const Start> first = starts.of(0, make);
    static_cast<void>(starts.of(1, make));
    EXPECT_FALSE(first.expired());
    static_cast<void>(starts.of(2, make));
    EXPECT_TRUE(first.expired());
    static_cast<void>(starts.of(1, make));
    EXPECT_EQ(made, 3);
}

TEST(OrderOfStarts, HasAllMembersAndFewReplicatesAtATime) {
    std::vector<Member> members;
    for (std::uint32_t regime = 0; regime < 5; ++regime) {
        for (std::uint32_t replicate = 0; replicate < 7; ++replicate) {
            members.push_back({.regime = regime, .replicate = replicate});
        }
    }
    for (const std::size_t at_a_time : {1U, 2U, 3U, 16U}) {
        const std::vector<Member> ordered = in_order_of_starts(members, at_a_time);
        EXPECT_TRUE(std::is_permutation(ordered.begin(), ordered.end(), members.begin(), members.end()));
        // The first ones begin with different starts; a start is made again for nobody.
        std::set<std::uint32_t> first;
        for (std::size_t i = 0; i < std::min<std::size_t>(at_a_time, 7); ++i) {
            first.insert(ordered[i].replicate);
        }
        EXPECT_EQ(first.size(), std::min<std::size_t>(at_a_time, 7));
        Starts starts{at_a_time};
        std::size_t made = 0;
        for (const Member& member : ordered) {
            static_cast<void>(starts.of(member.replicate, [&] {
                ++made;
                return any_start();
            }));
        }
        EXPECT_EQ(made, 7U);
    }
}

}  // namespace
}  // namespace coupling::decades::starts_test
