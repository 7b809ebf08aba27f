#include "coupling/assessments/today/tables.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/table/table.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::tables_test {
namespace {

using small_runs::SmallRun;
using small_runs::TestFolder;

config::Table read(const std::string& text) {
    std::istringstream in{text};
    return config::Table::read(in, "table.csv");
}

SmallRun some_rocks() {
    SmallRun run;
    run.fall(400);
    return run;
}

/// A table of a run.
config::Table table_of(const SmallRun& run, const char* file) {
    const TestFolder folder;
    write_tables(run.results(), figures_of(run.results()), folder.path());
    return read(small_runs::text_of(folder.path() / "tables" / file));
}

TEST(WriteTables, AreAllReadableTables) {
    const SmallRun run = some_rocks();
    const TestFolder folder;
    for (const WrittenFile& file : write_tables(run.results(), figures_of(run.results()), folder.path())) {
        EXPECT_GT(read(small_runs::text_of(folder.path() / file.path)).rows(), 0U) << file.path;
        EXPECT_FALSE(file.sentence.empty());
    }
}

TEST(WriteTargets, HasARowForEachTargetAndSlope) {
    const SmallRun run = some_rocks();
    const config::Table table = table_of(run, "targets.csv");
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
    const config::Table table = table_of(run, "protection.csv");
    EXPECT_EQ(table.text(0, "protection_percent"), "75.000");
    EXPECT_LT(std::stod(table.text(0, "protection_low_percent")), 75.0);
    EXPECT_GT(std::stod(table.text(0, "protection_high_percent")), 75.0);
    EXPECT_EQ(table.text(0, "rocks_for_half_interval"), "1600");
    EXPECT_EQ(table.text(1, "protection_percent"), "") << "no rock arrives at the house";
}

TEST(WriteRunOut, CountsEveryRockOnce) {
    const SmallRun run = some_rocks();
    const config::Table table = table_of(run, "run_out.csv");
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
    const config::Table table = table_of(run, "run_out.csv");
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
    const config::Table table = table_of(run, "stems.csv");
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
    EXPECT_EQ(small_runs::text_of(folder.path() / "tables/targets.csv").find(",forest,"), std::string::npos);
}

}  // namespace
}  // namespace coupling::tables_test
