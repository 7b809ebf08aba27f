#include "coupling/assessments/vary/regime_study.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

#include "config/table/table.hpp"
#include "coupling/assessments/vary/write_table.hpp"

namespace coupling::vary::regime_study_test {
namespace {

/// A run in which three regimes have these protections at the road, the mean of three replicates that
/// scatter.
RegimeRun run_of(double first, double second, double third, const std::string& value = {},
                 const std::array<double, 3>& scatter = {0.1, 0.2, 0.3}) {
    RegimeRun run;
    run.combination.values = {value};
    run.combination.alone = value.empty() ? "" : "release.diameter_m";
    const double percent[] = {first, second, third};
    const char* names[] = {"none", "groups", "slits"};
    for (std::size_t i = 0; i < 3; ++i) {
        RegimeOutcome outcome;
        outcome.regime = names[i];
        outcome.climate = "present";
        outcome.target = "road";
        outcome.protection_percent = percent[i];
        outcome.by_replicate = {percent[i] - scatter[i], percent[i], percent[i] + scatter[i]};
        outcome.rank = 1;
        for (const double other : percent) {
            outcome.rank += other > percent[i] ? 1 : 0;
        }
        run.regimes.push_back(outcome);
    }
    return run;
}

std::vector<bool> changes(const RegimeRun& run) {
    std::vector<bool> all;
    for (const RegimeOutcome& each : run.regimes) {
        all.push_back(each.changes_rank);
    }
    return all;
}

TEST(RankChanges, MarkThePairThatExchangedItsOrder) {
    std::vector<RegimeRun> runs{run_of(90, 80, 70), run_of(70, 60, 50), run_of(90, 69, 70),
                                run_of(60, 80, 70)};
    mark_rank_changes(runs);
    EXPECT_EQ(changes(runs[0]), (std::vector<bool>{false, false, false}));
    EXPECT_EQ(changes(runs[1]), (std::vector<bool>{false, false, false})) << "all lower, same order";
    EXPECT_EQ(changes(runs[2]), (std::vector<bool>{false, true, true}));
    EXPECT_EQ(changes(runs[3]), (std::vector<bool>{true, true, true}));
}

TEST(RankChanges, AreNoneWhereATieIsBrokenOrMade) {
    std::vector<RegimeRun> runs{run_of(90, 80, 80), run_of(90, 81, 80), run_of(90, 80, 81),
                                run_of(80, 80, 80)};
    mark_rank_changes(runs);
    for (const RegimeRun& run : runs) {
        EXPECT_EQ(changes(run), (std::vector<bool>{false, false, false}));
    }
}

TEST(RankChanges, AreNoneWherePairsOfReplicatesDoNotKnowThem) {
    // Regimes exchange their order by a point; replicates scatter by four, each regime in its own way.
    std::vector<RegimeRun> runs{run_of(90, 80.5, 79.5, "1", {1, 4, -4}),
                                run_of(90, 79.5, 80.5, "2", {1, 4, -4})};
    mark_rank_changes(runs);
    EXPECT_EQ(changes(runs[1]), (std::vector<bool>{false, false, false}));
    // One replicate knows no chance.
    runs = {run_of(90, 80, 70), run_of(70, 80, 90)};
    for (RegimeRun& run : runs) {
        for (RegimeOutcome& regime : run.regimes) {
            regime.by_replicate.resize(1);
        }
    }
    mark_rank_changes(runs);
    EXPECT_EQ(changes(runs[1]), (std::vector<bool>{false, false, false}));
}

TEST(RankChanges, CompareWithinATargetAndAClimate) {
    std::vector<RegimeRun> runs{run_of(90, 80, 70), run_of(90, 80, 70)};
    for (RegimeRun& run : runs) {
        run.regimes[2].climate = "warm";
    }
    runs[1].regimes[2].protection_percent = 85;  // above `groups`, but in the other climate
    runs[1].regimes[2].by_replicate = {84.9, 85.0, 85.1};
    mark_rank_changes(runs);
    EXPECT_EQ(changes(runs[1]), (std::vector<bool>{false, false, false}));
}

TEST(RegimeTable, HasARowOfEachRunAndRegime) {
    std::vector<RegimeRun> runs{run_of(90, 80, 70), run_of(79, 80, 70, "2")};
    mark_rank_changes(runs);
    // Differences 1, 3, 5: mean 3, Student's t over sqrt(3) replicates (95 %).
    runs[1].regimes[1].difference = decades::difference_of({1.0, 3.0, 5.0});
    runs[1].cheapest = "groups";
    const std::vector<Factor> factors{{.setting = "release.diameter_m", .values = {"2"}}};
    std::ostringstream out;
    write_regime_table(out, factors, runs);
    std::istringstream in{out.str()};
    const config::Table table = config::Table::read(in, "vary.csv");
    ASSERT_EQ(table.rows(), 6U);
    EXPECT_EQ(table.text(0, "moved"), "none");
    EXPECT_EQ(table.text(4, "moved"), "alone");
    EXPECT_EQ(table.text(4, "release.diameter_m"), "2");
    EXPECT_EQ(table.text(4, "regime"), "groups");
    EXPECT_EQ(table.text(4, "rank"), "1");
    EXPECT_EQ(table.text(4, "rank_changes"), "yes");
    EXPECT_EQ(table.text(5, "rank_changes"), "no");
    EXPECT_EQ(table.text(4, "pairs"), "3");
    EXPECT_NEAR(std::stod(table.text(4, "difference_percent")), 3.0, 1e-3);
    EXPECT_NEAR(std::stod(table.text(4, "difference_low_95")), 3.0 - 4.302653 * 2.0 / std::sqrt(3.0), 1e-3);
    EXPECT_EQ(table.text(3, "pairs"), "") << "the first regime is the reference";
    EXPECT_EQ(table.text(4, "cheapest_that_keeps"), "groups");
    EXPECT_EQ(table.text(0, "cheapest_that_keeps"), "");
}

}  // namespace
}  // namespace coupling::vary::regime_study_test
