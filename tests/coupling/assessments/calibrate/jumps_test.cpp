#include "coupling/assessments/calibrate/model/jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "config/random/distributions.hpp"
#include "coupling/assessments/calibrate/model/seen_of.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::calibrate::jumps_test {
namespace {

Opened opened_with(const std::string& impacts) {
    const SampleProject project;
    project.write("impacts.csv", impacts);
    return open(project, {"observed.impacts=impacts.csv"});
}

TEST(Jumps, LieBetweenImpactsOfOneTrack) {
    const Opened opened = opened_with(
        "x_m,y_m,track,ground,group\n1040,2050,a,3,\n1050,2040,b,,east\n1043,2054,a,,\n1050,2052,b,,east\n"
        "1055,2054,a,,\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    const std::vector<TrackJump> jumps = jumps_along(opened.site->observed_events.impacts);
    ASSERT_EQ(jumps.size(), 3U);
    EXPECT_DOUBLE_EQ(jumps[0].length_m, 5.0);
    EXPECT_DOUBLE_EQ(jumps[1].length_m, 12.0);
    EXPECT_DOUBLE_EQ(jumps[2].length_m, 12.0);
    EXPECT_EQ(jumps[0].group, "a");
    EXPECT_EQ(jumps[1].group, "east");
    EXPECT_EQ(jumps[0].ground, 3);
    EXPECT_TRUE(grounds_of(jumps).empty()) << "the ground of some is not known";
    EXPECT_EQ(grounds_of(std::span{jumps}.first(1)), std::vector<int>{3});
    EXPECT_DOUBLE_EQ(least_jump_m(jumps, {}), 5.0);
    CalibrateSettings settings;
    settings.least_jump_m = 7.0;
    EXPECT_DOUBLE_EQ(least_jump_m(jumps, settings), 7.0);
}

TEST(Jumps, NeedTracksAndLengths) {
    const Opened opened = opened_with("x_m,y_m,track\n1040,2050,a\n1040,2050,a\n1050,,a\n1050,2050,\n");
    EXPECT_EQ(opened.code, config::ExitCode::data);
    for (const char* found : {"impacts.csv:3:", "the place of the row before on track 'a'",
                              "impacts.csv:4:", "no y_m", "impacts.csv:5:", "no track"}) {
        EXPECT_NE(opened.errors.find(found), std::string::npos) << found << "\n" << opened.errors;
    }
}

TEST(Jumps, OfTheModelCountWhereSuchJumpsWereSeen) {
    Observation observation{.seen = Seen::jumps, .name = "jumps"};
    observation.grounds = {3};
    observation.least_jump_m = 2.0;
    SetRocks rocks;
    rocks.jumps = {{1.0F, 3}, {2.0F, 3}, {5.0F, 1}, {6.0F, 3}};
    const Sample seen = seen_of(rocks, observation, {});
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen.points[1].x(), 6.0);
}

/// Two samples of jumps by one law are as near as samples of the model are; by another law they are not.
TEST(Jumps, ThatTheModelMakesAreAsNearToItAsItIsToItself) {
    const auto jumps_with = [](double mean_m, std::uint64_t number) {
        config::RandomStream stream{{1, 0, 0, number}, config::Purpose::parameter};
        SetRocks rocks;
        for (int i = 0; i < 400; ++i) {
            rocks.jumps.push_back({static_cast<float>(config::exponential(stream.uniform(), mean_m)), 3});
        }
        return rocks;
    };
    Observation observation{.seen = Seen::jumps, .name = "jumps"};
    observation.least_jump_m = 2.0;
    std::vector<std::vector<Sample>> sets;
    for (std::uint64_t set = 0; set < 20; ++set) {
        sets.push_back({seen_of(jumps_with(8.0, set), observation, {})});
    }
    const SelfDistance scale = self_distance(sets, {{60, 0}}, 1, 1);
    const auto distance_of = [&](double mean_m) {
        const Sample seen = seen_of(jumps_with(mean_m, 99), observation, {});
        return scale.together({energy_distance(thinned(seen, 60), thinned(sets[0][0], 60))});
    };
    EXPECT_LT(distance_of(8.0), scale.at_95);
    EXPECT_GT(distance_of(16.0), scale.at_95);
}

}  // namespace
}  // namespace coupling::calibrate::jumps_test
