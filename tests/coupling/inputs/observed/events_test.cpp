#include "coupling/inputs/observed/events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coupling::observed::events_test {
namespace {

const EventComparison* named(const std::vector<EventComparison>& all, const std::string& name) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const EventComparison& one) { return one.name() == name; });
    return found == all.end() ? nullptr : &*found;
}

ObservedPassage passage(std::uint32_t target, double speed_mps, const std::string& group = "") {
    ObservedPassage one;
    one.target = target;
    one.speed_mps = speed_mps;
    one.group = group;
    return one;
}

TEST(ComparePassages, HoldsEachTargetAgainstItsOwnArrivals) {
    const ObservedEvents observed{{passage(0, 10.0), passage(0, 14.0), passage(1, 3.0)}, {}, 6};
    const std::vector<SimulatedPassage> simulated{{0, 11.0, 1.0, 50.0, 40.0},
                                                  {0, 13.0, 2.0, 60.0, 50.0},
                                                  {0, 15.0, 0.0, 70.0, 60.0},
                                                  {1, 4.0, 0, 0, 0}};
    const auto all = compare_passages(observed, simulated, std::vector<std::string>{"road", "house"}, 30);
    const EventComparison* speed = named(all, "passage.speed_mps:road");
    ASSERT_NE(speed, nullptr);
    EXPECT_EQ(speed->observed.count, 2U);
    EXPECT_DOUBLE_EQ(speed->observed.mean, 12.0);
    EXPECT_DOUBLE_EQ(speed->observed.deviation, std::sqrt(8.0));
    EXPECT_DOUBLE_EQ(speed->simulated.mean, 13.0);
    EXPECT_DOUBLE_EQ(speed->simulated.quantiles[2], 13.0);
    // Distribution functions: 1/2 against 0 from 10 to 11, 1/2 against 2/3 from 13 to 14, 1 against 2/3
    // to 15.
    EXPECT_DOUBLE_EQ(speed->largest_distance, 0.5);
    // Heights were not measured.
    EXPECT_EQ(named(all, "passage.height_m:road"), nullptr);
    const EventComparison* share = named(all, "passage.passing_share:road");
    ASSERT_NE(share, nullptr);
    EXPECT_DOUBLE_EQ(share->observed.mean, 2.0 / 6.0);
    EXPECT_DOUBLE_EQ(share->simulated.mean, 3.0 / 30.0);
    EXPECT_TRUE(std::isnan(share->largest_distance));
    EXPECT_DOUBLE_EQ(named(all, "passage.speed_mps:house")->simulated.mean, 4.0);
}

TEST(ComparePassages, TellsGroupsApart) {
    const ObservedEvents observed{{passage(0, 10.0, "a"), passage(0, 14.0, "b")}, {}, 0};
    const std::vector<SimulatedPassage> simulated{{0, 12.0, 0, 0, 0}};
    const auto all = compare_passages(observed, simulated, std::vector<std::string>{"road"}, 1);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_DOUBLE_EQ(named(all, "passage.speed_mps:road:b")->observed.mean, 14.0);
}

ObservedImpact impact(std::optional<int> ground, double in_mps, double out_mps, double angle_out_deg) {
    ObservedImpact one;
    one.ground = ground;
    one.speed_in_mps = in_mps;
    one.speed_out_mps = out_mps;
    one.angle_out_deg = angle_out_deg;
    return one;
}

TEST(CompareImpacts, TakesTheSameGroundsAndLeavesOutAnglesOfRocksThatStay) {
    const std::vector<ObservedImpact> observed{impact(3, 10.0, 5.0, 20.0), impact(3, 8.0, 0.0, 0.0)};
    const std::vector<SimulatedImpact> simulated{
        {3, 10.0, 6.0, 30.0, 15.0}, {3, 10.0, 0.0, 30.0, 0.0}, {5, 10.0, 9.0, 30.0, 5.0}};
    const auto all = compare_impacts(observed, simulated);
    const EventComparison* ratio = named(all, "impact.speed_ratio");
    ASSERT_NE(ratio, nullptr);
    EXPECT_DOUBLE_EQ(ratio->observed.mean, 0.25);
    EXPECT_DOUBLE_EQ(ratio->simulated.mean, 0.3);  // ground 5 does not count
    const EventComparison* angle = named(all, "impact.angle_out_deg");
    ASSERT_NE(angle, nullptr);
    EXPECT_EQ(angle->observed.count, 1U);
    EXPECT_EQ(angle->simulated.count, 1U);
    EXPECT_DOUBLE_EQ(angle->simulated.mean, 15.0);
    EXPECT_EQ(named(all, "impact.angle_in_deg"), nullptr);

    const std::vector<ObservedImpact> anywhere{impact({}, 10.0, 5.0, 20.0)};
    EXPECT_EQ(named(compare_impacts(anywhere, simulated), "impact.speed_ratio")->simulated.count, 3U);
}

}  // namespace
}  // namespace coupling::observed::events_test
