#include "validation/engine/forest_cases/shared/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/validation/forest_cases/case_runs.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/screen.hpp"
#include "validation/engine/validate.hpp"

namespace coupling::validation::forest_cases::comparison_test {
namespace {

/// The sample of a file in validation/README.md, such as "case.ini" of "forest_light".
std::string sample_in_readme(const std::string& file, const std::string& kind) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/validation/README.md"};
    const std::string readme{std::istreambuf_iterator<char>{in}, {}};
    const std::size_t named = readme.find("\n`" + file + "` of `" + kind + "`:\n");
    EXPECT_NE(named, std::string::npos) << file << " of " << kind;
    const std::size_t begin = readme.find('\n', readme.find("```", named)) + 1;
    return readme.substr(begin, readme.find("```", begin) - begin);
}

TEST(ForestCase, RunsTheSamplesOfTheReadme) {
    // The tables that the samples leave out are those of a shipped case.
    const std::map<std::string, std::vector<std::string>> samples{
        {"forest_production", {"case.ini", "criteria.csv", "runs.csv"}},
        {"forest_light", {"case.ini", "criteria.csv", "slopes.csv", "sensors.csv"}}};
    for (const auto& [kind, names] : samples) {
        CaseFiles files = shipped(kind);
        if (kind == "forest_light") {
            files.texts.erase("ground.csv");
        }
        for (const std::string& name : names) {
            files.texts[name] = sample_in_readme(name, kind);
        }
        const CaseResult result = result_of(files);
        const auto rows =
            std::count(files.texts["criteria.csv"].begin(), files.texts["criteria.csv"].end(), '\n');
        EXPECT_EQ(std::count_if(result.rows.begin(), result.rows.end(),
                                [](const VerdictRow& row) {
                                    return row.low && std::isfinite(row.default_value.value);
                                }),
                  rows - 1)
            << kind;
        // Tables of the shipped case that the sample does not name lie beside it.
        const auto others =
            std::count_if(result.warnings.begin(), result.warnings.end(), [](const std::string& warning) {
                return warning.find(".csv is not read; ") == std::string::npos;
            });
        EXPECT_EQ(others == 0, kind != "forest_light") << "light of the slopes left out";
    }
}

TEST(ForestCase, IsNoneWithoutItsKind) {
    CaseFiles files = shipped("vaujany_open");
    replace(files.texts["case.ini"], "kind = slope", "");
    EXPECT_EQ(problem_of(files), "") << "rocks on a slope";
}

TEST(ForestCase, WarnsThatNothingJudges) {
    CaseFiles files = shipped("forest_production");
    files.texts.erase("criteria.csv");
    const CaseResult result = result_of(files);
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_EQ(result.warnings[0].find("nothing is judged: "), 0U) << result.warnings[0];
    EXPECT_EQ(result.rows.size(), 6U) << "the figures help without bounds too";
    EXPECT_FALSE(misses_any(result));
}

TEST(LightCase, MissesTheCorrelationOnTheSouthSlopeAlone) {
    const CaseResult result = result_of(shipped("forest_light"));
    for (const VerdictRow& row : result.rows) {
        EXPECT_EQ(row.default_verdict == Verdict::missed,
                  row.quantity == "tree_light_correlation:slope_35_south")
            << row.quantity;
        EXPECT_EQ(row.strict_verdict, Verdict::no_criterion) << row.quantity;
        EXPECT_FALSE(row.label.empty()) << row.quantity;
    }
    EXPECT_TRUE(misses_any(result));
}

TEST(LightCase, ShowsEveryTreeOnEverySlope) {
    const CaseResult result = result_of(shipped("forest_light"));
    ASSERT_EQ(result.plots.size(), 2U);
    for (const PlotGroup& group : result.plots) {
        ASSERT_EQ(group.plots.size(), 3U);
        for (const Plot& plot : group.plots) {
            EXPECT_EQ(plot.series.back().points.size(), 333U);
        }
    }
}

TEST(LightCase, KnowsNoCorrelationOfOneSensor) {
    CaseFiles files = shipped("forest_light");
    files.texts["sensors.csv"] = "x_m,y_m,light_slope_6\n50,50,0.1\n";
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule\nsensor_bias:slope_6,-1,1,independent,\n";
    const Values values = result_of(files).variants.front().values;
    EXPECT_TRUE(values.contains("sensor_bias:slope_6"));
    EXPECT_FALSE(values.contains("sensor_correlation:slope_6"));
}

TEST(ForestCase, SaysWhatChangesNothingWithoutRocks) {
    CaseChanges changes;
    changes.most_rocks = 20;
    changes.overrides = {"series.seed=3", "rockfall.preset=strict"};
    const ValidationCase of = read_case(shipped("forest_light"), changes);
    ASSERT_EQ(of.notes.size(), 3U);
    EXPECT_EQ(of.notes[0], "--rocks changes nothing here: no rock falls");
    EXPECT_EQ(of.notes[1], "series.seed changes nothing here: no rock falls");
    EXPECT_EQ(of.notes[2], "rockfall.preset changes nothing here: no rock falls");
}

}  // namespace
}  // namespace coupling::validation::forest_cases::comparison_test
