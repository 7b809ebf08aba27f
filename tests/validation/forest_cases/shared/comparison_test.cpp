#include "validation/engine/forest_cases/shared/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "tests/validation/forest_cases/case_runs.hpp"
#include "tests/validation/forest_cases/remeasured/synthetic_plot.hpp"
#include "validation/engine/kinds/verdict.hpp"
#include "validation/engine/screen.hpp"
#include "validation/engine/tables.hpp"
#include "validation/engine/validate.hpp"

namespace coupling::validation::forest_cases::comparison_test {
namespace {

/// Two of the shipped plantations, of spruce with its table and of fir without, up to age 50.
CaseFiles small_yield() {
    CaseFiles files = shipped("forest_yield");
    files.texts["sites.csv"] =
        "site,species,elevation_m,fertility,table,class\n"
        "piab_1000,piab,1000,0.8,guttenberg_1915,2\nabal_500,abal,500,0.8,,\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nvolume_ratio:piab_1000:50,0.5,2,fitted,,\n"
        "volume_m3pha:abal_500:40,1e6,2e6,independent,meant to be missed,no fir is that thick\n";
    replace(files.texts["case.ini"], "ages_years = 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140",
            "ages_years = 40, 50");
    replace(files.texts["case.ini"], "drawn_ages_years = 70, 100", "drawn_ages_years = 50");
    return files;
}

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
    // The tables that the samples leave out are those of a shipped case, or of the synthetic plot.
    const std::map<std::string, std::vector<std::string>> samples{
        {"forest_production", {"case.ini", "criteria.csv", "runs.csv"}},
        {"forest_light", {"case.ini", "criteria.csv", "slopes.csv", "sensors.csv"}},
        {"forest_remeasured", {"case.ini", "criteria.csv"}}};
    for (const auto& [kind, names] : samples) {
        CaseFiles files = kind == "forest_remeasured" ? remeasured::synthetic_case() : shipped(kind);
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

TEST(ForestCase, AsksForItsKind) {
    CaseFiles files = shipped("forest_light");
    replace(files.texts["case.ini"], "kind = forest_light\n", "");
    EXPECT_EQ(problem_of(files).find("validation/forest_light/case.ini: found no case.kind, and no slope for "
                                     "rocks, expected a line `kind = ` under [case] with one of slope, "),
              0U)
        << problem_of(files);
    files = shipped("forest_light");
    replace(files.texts["case.ini"], "kind = forest_light", "kind = forest_lihgt");
    EXPECT_NE(problem_of(files).find("found case.kind 'forest_lihgt', expected 'forest_light'"),
              std::string::npos)
        << problem_of(files);
    files = shipped("vaujany_open");
    replace(files.texts["case.ini"], "kind = slope", "");
    EXPECT_EQ(problem_of(files), "") << "rocks on a slope";
}

TEST(ForestCase, FindsTheKindThatAWordIsTheEndOf) {
    CaseFiles files = shipped("forest_production");
    replace(files.texts["case.ini"], "kind = forest_production", "kind = production");
    EXPECT_NE(problem_of(files).find("found case.kind 'production', expected 'forest_production'"),
              std::string::npos)
        << problem_of(files);
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

TEST(LightCase, RefusesACorrelationOfOneSensor) {
    CaseFiles files = shipped("forest_light");
    files.texts["sensors.csv"] = "x_m,y_m,light_slope_6\n50,50,0.1\n";
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule\nsensor_bias:slope_6,-1,1,independent,\n";
    const Values values = result_of(files).variants.front().values;
    EXPECT_TRUE(values.contains("sensor_bias:slope_6"));
    EXPECT_FALSE(values.contains("sensor_correlation:slope_6"));
    files.texts["criteria.csv"] += "fine_sensor_correlation:slope_6,0.5,1,independent,\n";
    EXPECT_NE(
        problem_of(files).find("criteria.csv:3:1: found 'fine_sensor_correlation:slope_6', which cannot be "
                               "computed: a correlation needs 3 places or more, and there is 1"),
        std::string::npos)
        << problem_of(files);
}

TEST(YieldCase, TakesClassesAndAgesOfAnyTable) {
    CaseFiles files = small_yield();
    files.texts["sites.csv"] =
        "site,species,elevation_m,fertility,table,class,latitude_deg\nmine,piab,1000,0.8,my table,II.5,46\n";
    // No basal area; ages as they were measured.
    files.texts["yield_tables.csv"] =
        "table,class,age_years,mean_height_m,stems_pha,mean_dbh_cm,volume_m3pha\n"
        "my table,II.5,23,6.5,4400,8.2,90\nmy table,II.5,37,12.4,2300,14.8,240\n"
        "my table,III,37,10.1,2700,12.6,170\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nvolume_ratio:mine:37,0.2,5,"
        "independent,,\n";
    replace(files.texts["case.ini"], "ages_years = 40, 50", "ages_years =");
    replace(files.texts["case.ini"], "drawn_ages_years = 50", "drawn_ages_years =\ntwins = no");
    const CaseResult result = result_of(files);
    EXPECT_FALSE(misses_any(result));
    const Values& values = result.variants.front().values;
    EXPECT_NEAR(values.at("volume_m3pha:mine:37").value / values.at("volume_ratio:mine:37").value, 240.0,
                1e-9)
        << "of its class";
    replace(files.texts["yield_tables.csv"], "my table,III,37", "my table,II.5,37");
    EXPECT_NE(problem_of(files).find("age 37 of my table, class II.5, a second time"), std::string::npos)
        << problem_of(files);
}

TEST(YieldCase, JudgesEachSiteAgainstItsTable) {
    const CaseResult result = result_of(small_yield());
    // Guttenberg, class II, age 50.
    const double ratio = row_of(result, "volume_ratio:piab_1000:50").default_value.value;
    const Values& values = result.variants.front().values;
    EXPECT_NEAR(values.at("volume_m3pha:piab_1000:50").value / ratio, 320.0, 1e-9);
    EXPECT_EQ(row_of(result, "volume_m3pha:abal_500:40").default_verdict, Verdict::missed);
    EXPECT_FALSE(values.contains("volume_ratio:abal_500:50"));
    EXPECT_TRUE(values.contains("layers_volume_m3pha:abal_500:50"));
}

TEST(YieldCase, GivesTheSameFiguresOnAnyNumberOfThreads) {
    const auto figures = [](int threads) {
        const CaseResult result = result_of(small_yield(), {}, threads);
        std::ostringstream out;
        write_table(out, "figures.csv", {&result, 1});
        write_table(out, "plots.csv", {&result, 1});
        return out.str();
    };
    EXPECT_EQ(figures(1), figures(3));
}

TEST(YieldCase, SharesTheFiguresThatAgree) {
    const Values values = result_of(small_yield()).variants.front().values;
    EXPECT_EQ(values.at("share_within:all:to_100").value, values.at("share_within:piab:to_100").value);
    EXPECT_TRUE(values.contains("top_height_ratio:piab_1000:50"));
    EXPECT_LE(values.at("greatest_density:piab_1000").value, 1.1);
}

TEST(YieldCase, GrowsTheSpeciesOfItsOwnFolder) {
    CaseFiles files = small_yield();
    files.texts["species.csv"] = std::string{config::shipped_table("species.csv")};
    const auto volume = [](const CaseFiles& of) {
        return result_of(of).variants.front().values.at("volume_m3pha:piab_1000:50").value;
    };
    const double as_shipped = volume(files);
    EXPECT_EQ(as_shipped, volume(small_yield()));
    std::string& text = files.texts["species.csv"];
    const std::size_t row = text.find("PIAB");
    const std::size_t density = text.find(",430,400,", row);
    ASSERT_NE(density, std::string::npos);
    text.replace(density, 9, ",230,400,");
    EXPECT_GT(volume(files), 1.1 * as_shipped) << "light wood makes more volume of the same mass";
}

TEST(YieldCase, AsksForRowsOfTheTableAndRisingAges) {
    CaseFiles files = small_yield();
    files.texts["sites.csv"] =
        "site,species,elevation_m,fertility,table,class\npiab_1000,piab,1000,0.8,guttenberg_1915,9\n";
    EXPECT_NE(problem_of(files).find("sites.csv:2:41: found class '9' of table 'guttenberg_1915', expected "
                                     "one of validation/forest_yield/yield_tables.csv: '1', '1.5', '2'"),
              std::string::npos)
        << problem_of(files);
    files = small_yield();
    replace(files.texts["case.ini"], "ages_years = 40, 50", "ages_years = 50, 40");
    EXPECT_NE(problem_of(files).find("yield.ages_years 40"), std::string::npos) << problem_of(files);
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

TEST(ForestCase, RefusesAProfileAndUnknownSettings) {
    CaseChanges changes;
    changes.profile_file = "mine.csv";
    changes.profile_text = "distance_m,height_m,surface\n0,500,fine_debris\n600,0,\n";
    EXPECT_NE(problem_of(shipped("forest_light"), changes).find("--profile for forest_light"),
              std::string::npos);
    const auto with = [](const std::string& text) {
        CaseChanges one;
        one.overrides = {text};
        return one;
    };
    EXPECT_NE(problem_of(shipped("forest_light"), with("yield.ages_years=50")), "");
    EXPECT_NE(problem_of(shipped("forest_light"), with("case.kind=forest_yield")), "");
    EXPECT_NE(problem_of(shipped("vaujany_open"), with("case.kind=forest_yield")), "");
    EXPECT_NE(problem_of(small_yield(), with("yield.age_years=50")), "");
}

TEST(ForestCase, NamesAMissingTableAndAnUnknownFigure) {
    CaseFiles files = shipped("forest_light");
    files.texts.erase("trees.csv");
    EXPECT_NE(problem_of(files).find("forest_light/trees.csv"), std::string::npos);
    files.texts["tree.csv"] = "";
    EXPECT_NE(problem_of(files).find("if it is 'tree.csv', rename it"), std::string::npos)
        << problem_of(files);
    files = shipped("forest_light");
    files.texts["criteria.csv"] += "tree_light_bais:slope_6,0,1,independent,,\n";
    EXPECT_NE(problem_of(files).find("'tree_light_bias:slope_6'"), std::string::npos) << problem_of(files);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::comparison_test
