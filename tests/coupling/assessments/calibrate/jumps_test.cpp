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

SetRocks jumps_with(double mean_m, std::uint64_t number, int count) {
    config::RandomStream stream{{1, 0, 0, number}, config::Purpose::parameter};
    SetRocks rocks;
    while (rocks.jumps.size() < static_cast<std::size_t>(count)) {
        const double length_m = config::exponential(stream.uniform(), mean_m);
        if (length_m < 60.0) {  // on the slope
            rocks.jumps.push_back({static_cast<float>(length_m), 3});
        }
    }
    return rocks;
}

/// Tracks of jumps, as a mapper writes them; who overlooks short ones.
std::string tracks_of(const SetRocks& rocks, double least_m) {
    std::string rows = "x_m,y_m,track,ground\n";
    int track = 0;
    for (const SetRocks::Jump& jump : rocks.jumps) {
        if (static_cast<double>(jump.length_m) >= least_m) {
            const std::string name = "," + std::to_string(track++) + ",3\n";
            rows += "1040,2050" + name + std::to_string(1040.0 + static_cast<double>(jump.length_m)) +
                    ",2050" + name;
        }
    }
    return rows;
}

/// Jumps of the model through their file, the hold-out and the samples of the sets. Of 20 honest surveys one
/// is expected beyond the 95 % point; five or more are (binomial) no chance (0.3 %).
TEST(Jumps, ThatTheModelMakesAreAsNearToItAsItIsToItself) {
    const auto as_far = [](double mean_seen_m, std::uint64_t number) {
        const Opened opened = opened_with(tracks_of(jumps_with(mean_seen_m, number, 80), 2.0));
        EXPECT_TRUE(opened.site) << opened.errors;
        CalibrateSettings settings;
        settings.least_jump_m = 2.0;
        const std::vector<Observation> all = observations_on(*opened.site, settings, number);
        EXPECT_EQ(all.size(), 1U);
        EXPECT_FALSE(all[0].held_out.empty());
        std::vector<std::vector<Sample>> sets;
        for (std::uint64_t set = 0; set < 20; ++set) {
            sets.push_back({seen_of(jumps_with(8.0, 1000 + set, 400), all[0], {})});
        }
        const SelfDistance scale = self_distance(sets, {{all[0].fit.size(), 0}}, 1, 1);
        config::RandomStream stream{{2, 0, 0, number}, config::Purpose::parameter};
        const Sample simulated =
            drawn_from({&sets[0][0]}, 1, all[0].fit.size(), [&] { return stream.uniform(); });
        return scale.together({energy_distance(all[0].fit, simulated)}) / scale.at_95;
    };
    int beyond = 0;
    for (std::uint64_t survey = 0; survey < 20; ++survey) {
        beyond += as_far(8.0, survey) > 1.0 ? 1 : 0;
    }
    EXPECT_LT(beyond, 5);
    EXPECT_GT(as_far(16.0, 3), 1.0);
}

}  // namespace
}  // namespace coupling::calibrate::jumps_test
