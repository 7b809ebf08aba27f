#include "coupling/assessments/today/summary.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/coupling/results/small_run.hpp"

namespace coupling::summary_test {
namespace {

using small_runs::SmallRun;

nlohmann::json summary_of(const SmallRun& run) {
    std::ostringstream out;
    write_summary(out, run.results(), figures_of(run.results()), {{"tables/targets.csv", "What arrives."}});
    return nlohmann::json::parse(out.str());
}

TEST(WriteSummary, HoldsFiguresByTargetAndSlope) {
    SmallRun run;
    run.fall(400);
    const nlohmann::json summary = summary_of(run);
    const nlohmann::json& road = summary["targets"][0];
    EXPECT_EQ(road["id"], "road");
    EXPECT_EQ(road["bare"]["reached"]["rocks"], 40);
    EXPECT_EQ(road["protection"]["effect_percent"], 75.0);
    EXPECT_TRUE(road["bare"]["energy_kj"]["p95_interval_95"][1].is_null()) << "40 arrivals do not bound it";
    EXPECT_TRUE(summary["targets"][1]["protection"].is_null());
    EXPECT_EQ(summary["slopes"]["forest"]["stop_reasons"]["tree"]["rocks"], 390);
    EXPECT_EQ(summary["run"]["seed"], 1);
    EXPECT_EQ(summary["version"], "0.1.0");
}

TEST(WriteSummary, ListsSettingsWithUnitAndWhetherChanged) {
    const nlohmann::json settings = summary_of(SmallRun{})["settings"];
    ASSERT_EQ(settings.size(), 2U);
    EXPECT_EQ(settings[0]["changed"], false);
    EXPECT_EQ(settings[1]["key"], "release.density_kgpm3");
    EXPECT_EQ(settings[1]["value"], 2500);
    EXPECT_EQ(settings[1]["unit"], "kg/m3");
    EXPECT_EQ(settings[1]["changed"], true);
}

TEST(WriteSummary, CarriesInputsWarningsProjectionAndFiles) {
    const nlohmann::json summary = summary_of(SmallRun{});
    EXPECT_EQ(summary["inputs"][0]["hash"], "0123456789abcdef");
    EXPECT_EQ(summary["warnings"].size(), 1U);
    EXPECT_EQ(summary["run"]["projection"], small_runs::austria_lambert);
    EXPECT_EQ(summary["files"][0]["path"], "tables/targets.csv");
}

TEST(WriteSummary, OfAnEmptyRunIsJsonWithoutFigures) {
    const nlohmann::json summary = summary_of(SmallRun{});
    EXPECT_TRUE(summary["slopes"]["bare"]["run_out_m"]["mean"].is_null());
}

}  // namespace
}  // namespace coupling::summary_test
