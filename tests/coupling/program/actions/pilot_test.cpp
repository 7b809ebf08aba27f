#include "coupling/program/actions/pilot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

#include "coupling/inputs/site_falls.hpp"
#include "coupling/program/actions/estimate.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::pilot_test {
namespace {

/// A clock that a test can know: each look at it takes some time.
struct Clock {
    double step_s;
    double now_s = 0.0;
    int looks = 0;

    double operator()() {
        ++looks;
        return now_s += step_s;
    }
};

double pilot_with(Clock& clock, const std::string& rocks) {
    const SampleProject project;
    const Opened opened =
        open(project, {"rockfall.motion=rigid", "release.shape=cube", "release.rocks=" + rocks});
    EXPECT_TRUE(opened.site) << opened.errors;
    return opened.site ? pilot_falls(*opened.scenario, *opened.site, std::ref(clock)).seconds_per_rock : 0.0;
}

TEST(Pilot, EndsAfterASecondWithTheMeanOfItsRocks) {
    Clock clock{0.125};  // of a power of two: sums are exact
    // Before the first rock, after each from the eighth on until a second has passed, and at the end.
    EXPECT_DOUBLE_EQ(pilot_with(clock, "40"), (8 + 1) * 0.125 / 15);
    EXPECT_EQ(clock.looks, 1 + 8 + 1);
}

TEST(Pilot, SeesAFewRocksHoweverSlowTheyAre) {
    Clock clock{4.0};
    EXPECT_DOUBLE_EQ(pilot_with(clock, "40"), 2 * 4.0 / 8);
}

TEST(Pilot, EndsWithTheLastRock) {
    Clock clock{0.125};
    EXPECT_DOUBLE_EQ(pilot_with(clock, "4"), 0.125 / 4);
    EXPECT_EQ(clock.looks, 2);
}

TEST(Pilot, SetsTheEstimate) {
    const SampleProject project;
    const Opened opened = open(project, {"release.rocks=40"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto with = [&](int threads, const PilotFalls& pilot) {
        return estimate_of(*opened.scenario, *opened.site, threads, 3.0,
                           [&](const Scenario&, const Site&) { return pilot; });
    };
    EXPECT_DOUBLE_EQ(with(1, {0.25, 0.0}).fall_seconds, 40 * 0.25);
    EXPECT_DOUBLE_EQ(with(8, {0.25, 0.0}).fall_seconds, 40 * 0.25 / 8);
    EXPECT_DOUBLE_EQ(with(1, {0.5, 0.0}).fall_seconds, 2 * with(1, {0.25, 0.0}).fall_seconds);
    EXPECT_DOUBLE_EQ(with(1, {0.25, 0.0}).read_seconds, 3.0);
    EXPECT_EQ(with(1, {0.25, 0.0}).percentile_bytes, 0U);
    EXPECT_EQ(with(1, {0.25, 2.0}).percentile_bytes, 2 * with(1, {0.25, 1.0}).percentile_bytes);
    // However many are foretold: no more than there are.
    EXPECT_EQ(with(1, {0.25, 1e12}).percentile_bytes,
              2 * rockfall::CellHistograms::largest_bytes(opened.site->map_frame));
}

TEST(Pilot, ForetellsTheTilesThatAllRocksTouch) {
    const SampleProject project;
    const Opened opened = open(project, {"release.rocks=3000", "output.cell_size_m=1"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const config::GridFrame frame = opened.site->map_frame_on_terrain();
    const SiteFalls falls{*opened.scenario, *opened.site, frame};
    std::array<rockfall::CellHistograms, 2> cells{rockfall::CellHistograms{frame},
                                                  rockfall::CellHistograms{frame}};
    rockfall::Worker worker{falls.assessment, {&cells[0], &cells[1]}};
    rockfall::ChunkRows rows;
    for (const rockfall::Chunk& chunk : rockfall::plan_chunks(opened.site->sources)) {
        rows.clear();
        worker.run(chunk, rows, nullptr, {});
    }
    double touched = 0.0;
    for (const rockfall::CellHistograms& of_slope : cells) {
        for (std::size_t tile = 0; tile < of_slope.tiles(); ++tile) {
            touched += of_slope.tile(tile).empty() ? 0.0 : 1.0;
        }
    }
    EXPECT_NEAR(pilot_falls(*opened.scenario, *opened.site).tiles / touched, 1.0, 0.2);
}

}  // namespace
}  // namespace coupling::pilot_test
