#include "coupling/assessments/today/tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "config/table/table.hpp"
#include "coupling/assessments/today/rows.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::tables_test {
namespace {

using testing::SmallRun;
using testing::TestFolder;

config::Table read(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "table.csv");
}

SmallRun some_rocks() {
    SmallRun run;
    run.fall(400);
    return run;
}

TEST(WriteTables, NameTheUnitOfEveryColumnThatHasOne) {
    constexpr std::array units{"_m",   "_cm",    "_s",        "_mps", "_kj", "_percent",
                               "_deg", "_per_m", "_per_1000", "_pm",  "_ps"};
    const std::vector<std::string> without{
        "rock",
        "impacts_by_ground",
        "cover",
        "zone",
        "source",
        "stop_reason",
        "jumps",
        "jump_angle_factor",
        "point",
        "tree_hits",
        "trees_broken",
        "target_id",
        "tree_id",
        "name",
        "kind",
        "rocks",
        "reached",
        "wkt",
        "species",
        "hits",
        "broken",
        "stopped",
        "hit_type",
        "or_more",
        "ground_impacts",
        "at_rest",
        "caught",
        "left_terrain",
        "gave_up",
        "stopped_by_tree",
        "stopped_by_log",
        "stopped_by_net",
        "reached_bare",
        "reached_forest",
        "reached_both",
        "too_few_rocks",
        "above_30_kj_rocks",
        "above_100_kj_rocks",
        "above_300_kj_rocks",
        "above_1000_kj_rocks",
        "rocks_for_half_interval",
        "jumps_per_rock",
        "ground_impacts_per_rock",
        "tree_hits_per_rock",
        "trees_broken_per_rock",
        "log_hits_per_rock",
        "logs_broken_per_rock",
        "log_hits",
        "logs_broken",
        "log_id",
        "outcome",
        "quantity",
        "unit",
        "bin_low",
        "bin_high",
        "code",
        "ground",
        "end_ground",
        "area_share",
        "soil",
        "r_n",
        "r_t",
        "p_stop",
        "friction",
        "friction_max",
        "restitution",
        "rolling_resistance",
        "not_stopped"};  // rocks; bin_low, bin_high: unit in its own column
    const SmallRun run = some_rocks();
    const TestFolder folder;
    std::vector<std::string> texts;
    for (const WrittenFile& file : write_tables(run.results(), figures_of(run.results()), folder.path())) {
        texts.push_back(testing::text_of(folder.path() / file.path));
    }
    for (const auto header :
         {write_rock_header, write_arrival_header, write_tree_hit_header, write_log_hit_header}) {
        std::ostringstream out;
        header(out);
        texts.push_back(out.str());
    }
    for (const std::string& text : texts) {
        for (const std::string& column : testing::columns_of(text)) {
            const bool has_unit = std::any_of(units.begin(), units.end(),
                                              [&](const char* unit) { return column.ends_with(unit); });
            EXPECT_TRUE(has_unit || std::find(without.begin(), without.end(), column) != without.end())
                << column;
        }
    }
}

TEST(WriteTables, AreAllReadableTables) {
    const SmallRun run = some_rocks();
    const TestFolder folder;
    for (const WrittenFile& file : write_tables(run.results(), figures_of(run.results()), folder.path())) {
        EXPECT_GT(read(testing::text_of(folder.path() / file.path)).rows(), 0U) << file.path;
        EXPECT_FALSE(file.sentence.empty());
    }
}

TEST(WriteTargets, HasARowForEachTargetAndSlope) {
    const SmallRun run = some_rocks();
    std::ostringstream out;
    write_targets(out, figures_of(run.results()), covers_of(run.results()));
    const config::Table table = read(out.str());
    ASSERT_EQ(table.rows(), 4U);
    EXPECT_EQ(table.text(0, "name"), "Road & <bridge>");
    EXPECT_EQ(table.text(0, "cover"), "forest");
    EXPECT_EQ(table.text(0, "reached"), "10");
    EXPECT_EQ(table.text(1, "reached"), "40");
    EXPECT_EQ(table.text(1, "share_percent"), "10.0000");
    EXPECT_EQ(table.text(1, "energy_95_high_kj"), "") << "40 arrivals do not bound a 95th percentile";
    EXPECT_EQ(table.text(2, "energy_mean_kj"), "");
    EXPECT_EQ(table.text(2, "energy_95_low_kj"), "");
}

TEST(WriteProtection, TellsTheEffectWithItsInterval) {
    const SmallRun run = some_rocks();
    std::ostringstream out;
    write_protection(out, figures_of(run.results()));
    const config::Table table = read(out.str());
    EXPECT_EQ(table.text(0, "protection_percent"), "75.000");
    EXPECT_LT(std::stod(table.text(0, "protection_low_percent")), 75.0);
    EXPECT_GT(std::stod(table.text(0, "protection_high_percent")), 75.0);
    EXPECT_EQ(table.text(0, "rocks_for_half_interval"), "1600");
    EXPECT_EQ(table.text(1, "protection_percent"), "") << "no rock arrives at the house";
}

TEST(WriteRunOut, CountsEveryRockOnce) {
    const SmallRun run = some_rocks();
    std::ostringstream out;
    write_run_out(out, run.results());
    const config::Table table = read(out.str());
    int bare = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        bare += table.text(row, "cover") == "bare" ? std::stoi(table.text(row, "rocks")) : 0;
    }
    EXPECT_EQ(bare, 400);
}

TEST(WriteRunOut, SetsRocksThatLeftApart) {
    SmallRun run = some_rocks();
    rockfall::RunTally& bare = run.tally.runs[index_of(Cover::bare)];
    rockfall::RockRecord left;
    left.end_m.x() = 195.0;  // further than all that stopped
    left.reason = rockfall::StopReason::left_terrain;
    bare.add(left);
    std::ostringstream out;
    write_run_out(out, run.results());
    const config::Table table = read(out.str());
    int stopped = 0;
    int not_stopped = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "cover") == "bare") {
            stopped += std::stoi(table.text(row, "rocks"));
            not_stopped += std::stoi(table.text(row, "not_stopped"));
        }
    }
    EXPECT_EQ(stopped, 400);
    EXPECT_EQ(not_stopped, 1);
}

TEST(WriteStems, ListsEveryTreeWithWhatItTook) {
    const SmallRun run = some_rocks();
    std::ostringstream out;
    write_stems(out, run.results());
    const config::Table table = read(out.str());
    ASSERT_EQ(table.rows(), 3U);
    EXPECT_EQ(table.text(0, "tree_id"), "17");
    EXPECT_EQ(table.text(0, "x_m"), "177025.00");
    EXPECT_EQ(table.text(0, "hits"), "200");
    EXPECT_EQ(table.text(0, "energy_kj"), "2000.000");
    EXPECT_EQ(table.text(2, "tree_id"), "a,b");
}

TEST(WriteTables, LeaveOutTheForestWhereThereIsNone) {
    SmallRun run = some_rocks();
    run.with_forest = false;
    const TestFolder folder;
    write_tables(run.results(), figures_of(run.results()), folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "tables/protection.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "tables/stems.csv"));
    EXPECT_EQ(testing::text_of(folder.path() / "tables/targets.csv").find(",forest,"), std::string::npos);
}

}  // namespace
}  // namespace coupling::tables_test
