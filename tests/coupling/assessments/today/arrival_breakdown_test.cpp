#include "coupling/assessments/today/arrival_breakdown.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "coupling/assessments/today/rows.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/figures.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::arrival_breakdown_test {
namespace {

using small_runs::SmallRun;

/// arrivals.csv as a run writes it: first the rocks of a chunk with forest, then those over the bare slope.
class Arrivals {
public:
    Arrivals() { write_header(out_, arrival_table()); }
    Arrivals& add(const SmallRun& run, std::uint64_t rock, Cover cover, float x_m, float y_m,
                  const char* target = "road") {
        const rockfall::Arrival arrival{true,  false, x_m,  y_m,  50e3F + 1000.0F * static_cast<float>(rock),
                                        40e3F, 11.0F, 0.4F, 0.9F, 1.4F};
        const Eigen::Vector2d origin_m = run.site.origin_m();
        TableOf<ArrivalOfRock>::Rows{out_, arrival_table()}.add({rock, target, cover, origin_m, arrival});
        return *this;
    }
    [[nodiscard]] Breakdown of(const SmallRun& run) const {
        const std::string written = out_.str();
        OwnRows rows{written, "arrivals.csv"};
        return breakdown_of(rows, *run.scenario, run.site);
    }
    [[nodiscard]] std::string text() const { return out_.str(); }

private:
    std::ostringstream out_;
};

std::uint64_t reached(const rockfall::TargetTally& tally, Cover cover) {
    return tally.by_cover[index_of(cover)].reached;
}

TEST(Breakdown, PutsArrivalsOnTheStretchesOfALine) {
    const SmallRun run;
    const Breakdown found = Arrivals{}
                                .add(run, 0, Cover::forest, 35.0F, 13.0F)
                                .add(run, 0, Cover::bare, 36.0F, 12.5F)
                                .add(run, 1, Cover::bare, 75.0F, 14.6F)
                                .of(run);
    ASSERT_EQ(found.lines.size(), 1U) << "a house is no line";
    const AlongLine& road = found.lines[0];
    EXPECT_NEAR(road.length_m(), 2.0 * std::hypot(40.0, 3.0), 1e-9);
    ASSERT_EQ(road.stretches.size(), 9U);
    EXPECT_EQ(reached(road.stretches[3].tally, Cover::forest), 1U);
    EXPECT_EQ(reached(road.stretches[3].tally, Cover::bare), 1U);
    EXPECT_EQ(road.stretches[3].tally.reached_both, 1U);
    EXPECT_EQ(reached(road.stretches[7].tally, Cover::bare), 1U);
    EXPECT_EQ(road.stretches[7].tally.reached_both, 0U);
    EXPECT_NEAR(road.stretches[7].tally.by_cover[index_of(Cover::bare)].energy_max_j, 51e3, 1.0);
    EXPECT_NEAR(road.stretches[7].tally.by_cover[index_of(Cover::bare)].top_height_max_m, 1.4, 1e-3);
    EXPECT_NEAR(road.stretches[0].middle_m.x(), 177000.0 + 5.0, 0.1);
}

TEST(Breakdown, CountsARockOnBothSlopesOnlyWhereItReachesTheSameStretch) {
    const SmallRun run;
    Arrivals arrivals;
    for (std::uint64_t rock = 0; rock < 3; ++rock) {  // all of them elsewhere than with forest
        arrivals.add(run, rock, Cover::forest, 35.0F, 13.0F);
    }
    for (std::uint64_t rock = 0; rock < 3; ++rock) {
        arrivals.add(run, rock, Cover::bare, 45.0F, 12.5F);
    }
    const AlongLine road = arrivals.of(run).lines[0];
    const PairedCounts first = paired_counts(road.stretches[3].tally);
    EXPECT_EQ(first.only_forest, 3U);
    EXPECT_EQ(first.only_bare, 0U);
    const PairedCounts second = paired_counts(road.stretches[4].tally);
    EXPECT_EQ(second.only_forest, 0U);
    EXPECT_EQ(second.only_bare, 3U);
    EXPECT_EQ(second.both, 0U);
    ASSERT_EQ(road.moved.size(), 3U);
    EXPECT_EQ(road.moved[0].forest, 3U);
    EXPECT_EQ(road.moved[0].bare, 4U);
}

TEST(Breakdown, KnowsARockAgainOverTheBareSlopeInLaterChunksToo) {
    const SmallRun run;
    const Breakdown found = Arrivals{}
                                .add(run, 2, Cover::forest, 35.0F, 13.0F)
                                .add(run, 1, Cover::bare, 35.0F, 13.0F)
                                .add(run, 2, Cover::bare, 35.0F, 13.0F)
                                .add(run, 50, Cover::forest, 35.0F, 13.0F)
                                .add(run, 50, Cover::bare, 35.0F, 13.0F)
                                .add(run, 50, Cover::bare, 55.0F, 5.0F, "house")
                                .of(run);
    ASSERT_EQ(found.zones.size(), 1U);
    EXPECT_EQ(found.zones[0].zone, 3U);
    EXPECT_EQ(found.zones[0].released, 100U);
    EXPECT_EQ(reached(found.zones[0].targets[0], Cover::forest), 2U);
    EXPECT_EQ(reached(found.zones[0].targets[0], Cover::bare), 3U);
    EXPECT_EQ(found.zones[0].targets[0].reached_both, 2U);
    EXPECT_EQ(reached(found.zones[0].targets[1], Cover::bare), 1U);
    EXPECT_EQ(found.zones[0].targets[1].reached_both, 0U);
}

TEST(Breakdown, GroupsRocksByTheirSizeWhereSizesDiffer) {
    SmallRun run;
    EXPECT_TRUE(Arrivals{}.of(run).sizes.empty()) << "one size";
    run.scenario->release.diameter_kind = DiameterKind::classes;
    run.scenario->release.diameter_classes_m = {0.5, 1.0};
    run.scenario->release.diameter_shares = {3.0, 1.0};
    Arrivals arrivals;
    for (std::uint64_t rock = 0; rock < 100; ++rock) {
        arrivals.add(run, rock, Cover::bare, 35.0F, 13.0F);
    }
    const Breakdown found = arrivals.of(run);
    ASSERT_EQ(found.sizes.size(), 2U);
    EXPECT_EQ(found.sizes[0].largest_m, 0.5);
    EXPECT_EQ(found.sizes[1].smallest_m, 1.0);
    EXPECT_EQ(found.sizes[0].released + found.sizes[1].released, 100U);
    // Of 100 draws with a share of 3/4: five standard deviations are 22.
    EXPECT_NEAR(static_cast<double>(found.sizes[0].released), 75.0, 22.0);
    for (const ReleaseGroup& group : found.sizes) {
        EXPECT_EQ(reached(group.targets[0], Cover::bare), group.released) << "every rock arrives";
    }
    run.scenario->release.diameter_kind = DiameterKind::uniform;
    run.scenario->release.diameter_low_m = 0.5;
    run.scenario->release.diameter_high_m = 2.0;
    const Breakdown classes = arrivals.of(run);
    ASSERT_EQ(classes.sizes.size(), 3U) << "0.5 to 1.0, to 1.5, to 2.0 m";
    std::uint64_t released = 0;
    for (const ReleaseGroup& group : classes.sizes) {
        EXPECT_NEAR(group.largest_m - group.smallest_m, 0.5, 1e-9);
        EXPECT_EQ(reached(group.targets[0], Cover::bare), group.released);
        released += group.released;
    }
    EXPECT_EQ(released, 100U);
}

TEST(Breakdown, RefusesRowsThatNoRunWrote) {
    const SmallRun run;
    const std::string good = Arrivals{}.add(run, 0, Cover::bare, 35.0F, 13.0F).text();
    const std::string row = good.substr(good.find('\n') + 1);
    for (const std::string& bad : {std::string{"0,road,bare\n"}, std::string{"x"} + row,
                                   row.substr(0, 20) + "\n", "0,nowhere" + row.substr(row.find(",bare"))}) {
        const std::string text = good + bad;
        OwnRows rows{text, "arrivals.csv"};
        EXPECT_THROW(breakdown_of(rows, *run.scenario, run.site), config::InputError) << bad;
    }
    EXPECT_THROW((OwnRows{"", "arrivals.csv"}), config::InputError);
}

TEST(Breakdown, IsUnknownWithoutTargetsOrArrivals) {
    SmallRun run;
    run.scenario->output.arrival_table = false;
    EXPECT_FALSE(breakdown_of(StreamedTables{{}, "none"}, *run.scenario, run.site).is_known);
    run.scenario->output.arrival_table = true;
    run.site.targets.clear();
    EXPECT_FALSE(breakdown_of(StreamedTables{{}, "none"}, *run.scenario, run.site).is_known);
}

}  // namespace
}  // namespace coupling::arrival_breakdown_test
