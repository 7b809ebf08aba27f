#include "validation/engine/years/years_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <regex>
#include <sstream>

#include "tests/validation/forest_cases/case_runs.hpp"
#include "validation/engine/tables.hpp"

namespace coupling::validation::years_case_test {
namespace {

using forest_cases::problem_of;
using forest_cases::replace;
using forest_cases::result_of;
using forest_cases::shipped;

/// So many years, the last ones judged, on a plot with so long sides.
CaseChanges few_years(int years, int from_year, int side_m, std::vector<std::string> more = {}) {
    CaseChanges changes;
    const std::string side = std::to_string(side_m);
    changes.overrides = {"run.years=" + std::to_string(years), "years.from_year=" + std::to_string(from_year),
                         "terrain.plane_width_m=" + side, "terrain.plane_length_m=" + side,
                         "run.replicates=1"};
    changes.overrides.insert(changes.overrides.end(), more.begin(), more.end());
    return changes;
}

/// Sites of forest_belts, and groups of species that are judged there.
CaseFiles belts_at(const std::string& sites, const std::string& groups = "") {
    CaseFiles files = shipped("forest_belts");
    files.texts["sites.csv"] = "site,words,terrain.plane_elevation_m,soil.type\n" + sites;
    files.texts["expected.csv"] = "site,group,species,published,source\n" + groups;
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule\n";
    return files;
}

const std::string two_sites = "e0500,500 m,500,1\ne1500,1500 m,1500,4\n";

double value_of(const CaseResult& result, const std::string& figure) {
    return result.variants.front().values.at(figure).value;
}

/// Deaths of old forests as a README names them, in % of the trees a year by elevation in m.
std::map<double, double> deaths_in_readme() {
    std::ifstream in{BANNWALD_SOURCE_DIR "/validation/forest_old/README.md"};
    std::string text{std::istreambuf_iterator<char>{in}, {}};
    std::replace(text.begin(), text.end(), '\n', ' ');
    static const std::regex sentence{
        "slope ([0-9., and]+) % of the trees from 12 cm on die in a year at ([0-9, and]+) m"};
    std::smatch part;
    std::map<double, double> deaths;
    if (std::regex_search(text, part, sentence)) {
        static const std::regex number{"[0-9.]*[0-9]"};
        const std::string percent = part[1];
        const std::string elevation_m = part[2];
        std::sregex_iterator rate{percent.begin(), percent.end(), number};
        for (std::sregex_iterator at{elevation_m.begin(), elevation_m.end(), number}, end;
             at != end && rate != end; ++at, ++rate) {
            deaths[std::stod(at->str())] = std::stod(rate->str());
        }
    }
    return deaths;
}

TEST(YearsCase, BringsTheBeltsInTheirOrder) {
    CaseFiles files = belts_at(
        two_sites + "e2000,2000 m,2000,5\n",
        "e0500,tolerant,fasy abal,,\ne0500,spruce,piab,,\ne1500,tolerant,fasy abal,,\n"
        "e1500,spruce,piab,,\ne1500,larch,lade,,\ne2000,spruce,piab,,\ne2000,larch_cembra,lade pice,,\n");
    files.texts["figures.sql"] =
        "-- figure deaths:{site} | places | deaths from 12 cm on at {site} | -\n"
        "SELECT (SELECT count(*) FROM judged_deaths WHERE site = :site AND dbh_cm >= 12) / CAST(:area_ha AS "
        "REAL)\n  / (SELECT count(*) FROM judged_years WHERE site = :site)\n"
        "  / (SELECT sum(stems_pha) / (SELECT count(*) FROM judged WHERE site = :site AND species = 'all')\n"
        "     FROM judged_classes WHERE site = :site AND dbh_from_cm >= 12);\n";
    // The larches that settled first live to 600 years; the case judges the years 600 to 800, too.
    const CaseResult result = result_of(files, few_years(700, 600, 60));
    EXPECT_GT(value_of(result, "margin:tolerant:e0500"), 0.0);
    EXPECT_LT(value_of(result, "share:spruce:e0500"), 0.33);
    EXPECT_GT(value_of(result, "margin:spruce:e1500"), 0.0);
    EXPECT_LT(value_of(result, "share:tolerant:e1500"), 0.3);
    // On this small plot only the order is asked for; the case judges the shares after 600 years.
    EXPECT_GT(value_of(result, "share:larch_cembra:e2000"), value_of(result, "share:larch:e1500") + 0.1);
    EXPECT_LT(value_of(result, "share:spruce:e2000"), value_of(result, "share:spruce:e1500"));
    EXPECT_GT(value_of(result, "biomass_tpha:e0500"), value_of(result, "biomass_tpha:e1500"));
    // The cembras that settled first still stand at 2000 m, so its biomass is that of one generation.
    EXPECT_GT(value_of(result, "biomass_tpha:e0500"), value_of(result, "biomass_tpha:e2000"));
    // A forest, no scree. One replicate of this plot has 94 +- 28 t/ha there (six seeds), so three are asked.
    const CaseResult high =
        result_of(belts_at("e2000,2000 m,2000,5\n"), few_years(700, 600, 60, {"run.replicates=3"}));
    EXPECT_GT(value_of(high, "biomass_tpha:e2000"), 50.0);
    // About 70 and 140 trees die on this plot; the README has means over a hectare and two centuries.
    const std::map<double, double> deaths = deaths_in_readme();
    ASSERT_EQ(deaths.size(), 5U);
    constexpr double by_chance = 0.35;
    const double at_500_m = deaths.at(500.0);
    EXPECT_NEAR(100.0 * value_of(result, "deaths:e0500"), at_500_m, by_chance * at_500_m);
    const double at_1500_m = 0.25 * deaths.at(1200.0) + 0.75 * deaths.at(1600.0);
    EXPECT_NEAR(100.0 * value_of(result, "deaths:e1500"), at_1500_m, by_chance * at_1500_m);
}

TEST(YearsCase, LetsPioneersGiveWayToTolerantSpecies) {
    const CaseFiles files = belts_at(
        "e0750,750 m,750,1\n", "e0750,tolerant,fasy abal,,\ne0750,pioneers,bepe soau lade pisy frex,,\n");
    const CaseResult early = result_of(files, few_years(40, 20, 60));
    const CaseResult late = result_of(files, few_years(600, 500, 60));
    EXPECT_GT(value_of(early, "share:pioneers:e0750"), 0.2);
    EXPECT_LT(value_of(late, "share:pioneers:e0750"), 0.15);  // larch grows old
    EXPECT_GT(value_of(late, "share:tolerant:e0750"), value_of(early, "share:tolerant:e0750"));
}

TEST(YearsCase, StacksTheSpeciesUpToTheWholeBiomass) {
    const CaseResult result = result_of(belts_at(two_sites), few_years(40, 20, 30, {"run.replicates=2"}));
    ASSERT_EQ(result.plots.size(), 2U);
    const std::vector<report::ChartRange>& top = result.plots[0].plots.at(1).series.back().ranges;
    ASSERT_EQ(top.size(), 2U);
    EXPECT_EQ(top[0].x, 500.0) << "sites in the order of their elevation";
    EXPECT_NEAR(top[0].high, value_of(result, "biomass_tpha:e0500"), 0.01);
    EXPECT_NEAR(top[1].high, value_of(result, "biomass_tpha:e1500"), 0.01);
    EXPECT_NEAR(result.plots[0].plots.at(0).series.back().ranges[0].high, 100.0, 0.01);
    ASSERT_EQ(result.plots[1].plots.size(), 2U);
    const std::vector<report::ChartRange>& years = result.plots[1].plots[0].series.front().ranges;
    EXPECT_EQ(years.front().x, 0.0);
    EXPECT_EQ(years.back().x, 40.0);
}

TEST(YearsCase, DrawsNothingOverElevationForSitesWhoseClimateDoesNotFollowIt) {
    CaseFiles files = belts_at("");
    const std::string head =
        "site,words,terrain.plane_elevation_m,climate.temperature_change_k,climate.precipitation_change\n";
    files.texts["sites.csv"] = head + "a,1500 m,1500,4,1\nb,500 m,500,0,0.7\n";
    EXPECT_EQ(result_of(files, few_years(10, 10, 30)).plots.size(), 1U);
    files.texts["sites.csv"] = head + "a,1500 m,1500,0,1\nb,500 m,500,0,0.7\n";
    EXPECT_EQ(result_of(files, few_years(10, 10, 30)).plots.size(), 1U) << "one site makes no line";
}

TEST(YearsCase, CountsAGroupAndTheGreatestOutsideOfItFromTheSameBiomass) {
    const CaseFiles files =
        belts_at("e0500,500 m,500,1\n",
                 "e0500,a,fasy,,\ne0500,b,abal piab lade pice pisy qupe acps frex bepe soau,,\n");
    const CaseResult result = result_of(files, few_years(60, 40, 30));
    const double a = value_of(result, "share:a:e0500");
    const double b = value_of(result, "share:b:e0500");
    EXPECT_GT(b, 0.0);
    EXPECT_LE(a + b, 1.0 + 1e-3);
    EXPECT_NEAR(value_of(result, "margin:b:e0500"), b - a, 1e-3) << "beech is all that is outside";
}

TEST(YearsCase, GivesTheSameFiguresOnAnyNumberOfThreadsAndOthersForAnotherSeed) {
    const auto figures = [](int threads, const std::string& seed) {
        const CaseResult result = result_of(belts_at(two_sites), few_years(40, 20, 30, {seed}), threads);
        std::ostringstream out;
        write_table(out, "figures.csv", {&result, 1});
        write_table(out, "plots.csv", {&result, 1});
        return out.str();
    };
    const std::string one = figures(1, "series.seed=1");
    EXPECT_EQ(one, figures(3, "series.seed=1"));
    EXPECT_NE(one, figures(3, "series.seed=2"));
}

TEST(YearsCase, CountsReplicatesWithASpeciesAndWoodThatStormsTook) {
    CaseFiles files = shipped("forest_disturbed");
    files.texts["sites.csv"] = "site,words,terrain.plane_elevation_m,soil.type\ne1200,1200 m,1200,3\n";
    files.texts["expected.csv"] = "site,group,species,published,source\n";
    files.texts["native.csv"] = "site,species\ne1200,PIAB\ne1200,PICE\n";
    files.texts.erase("criteria.csv");
    const std::vector<std::string> stormy{"run.replicates=2", "disturbance.storm_interval=1",
                                          "disturbance.first_year=50", "output.tree_list_years=60"};
    const CaseResult calm = result_of(files, few_years(49, 40, 40, {stormy[0], stormy[1], stormy[2]}));
    EXPECT_EQ(value_of(calm, "lost_to_wind_m3pha:e1200"), 0.0) << "storms begin in year 50";
    const CaseResult result = result_of(files, few_years(60, 50, 40, stormy));
    EXPECT_GT(value_of(result, "lost_to_wind_m3pha:e1200"), 0.0);
    EXPECT_EQ(value_of(result, "alive:piab:e1200"), 2.0);
    EXPECT_LE(value_of(result, "kept:pice:e1200"), value_of(result, "alive:pice:e1200"));
}

/// Two species of forest_demography, four stands of each cell, two years.
CaseResult small_demography(int threads = 2) {
    CaseFiles files = shipped("forest_demography");
    files.texts["sites.csv"] =
        "site,words,species,place,dbh_cm,larger_m2pha,terrain.plane_elevation_m,climate.precipitation_change,"
        "stands.number\nabal:2:30:5,optimum,abal,2,30,5,582,0.701,4\n"
        "abal:2:30:40,optimum,abal,2,30,40,582,0.701,6\nlade:1:15:20,hot edge,lade,1,15,20,201,0.590,47\n";
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule\nshare_growth:all:2,0,1,independent,x\n";
    CaseChanges changes;
    changes.overrides = {"run.replicates=4", "run.years=2", "years.from_year=2"};
    return result_of(files, changes, threads);
}

TEST(DemographyFolder, FindsLessGrowthUnderMoreCompetition) {
    const CaseResult result = small_demography();
    EXPECT_GT(value_of(result, "growth_mm_pyear:abal:2:30:5"),
              1.2 * value_of(result, "growth_mm_pyear:abal:2:30:40"));
    EXPECT_NEAR(value_of(result, "growth_ratio:abal:2:30:5"),
                value_of(result, "growth_mm_pyear:abal:2:30:5") / 8.1592, 1e-3);
    EXPECT_GE(value_of(result, "mortality_ratio:lade:1:15:20"), 0.0);
    const double agreeing = value_of(result, "share_growth:abal:2");
    EXPECT_TRUE(agreeing == 0.0 || agreeing == 0.5 || agreeing == 1.0) << "of two cells";
    EXPECT_EQ(agreeing, value_of(result, "share_growth:all:2"));
}

TEST(DemographyFolder, GivesTheSameFiguresOnAnyNumberOfThreads) {
    const auto figures = [](int threads) {
        const CaseResult result = small_demography(threads);
        std::ostringstream out;
        write_table(out, "figures.csv", {&result, 1});
        return out.str();
    };
    EXPECT_EQ(figures(1), figures(3));
}

TEST(YearsCase, SaysWhichLawsAreNotTheDefaultsOfARun) {
    CaseFiles files = shipped("forest_demography");
    files.texts["sites.csv"] =
        "site,words,species,place,dbh_cm,larger_m2pha,stands.number\nabal:2:30:5,optimum,abal,2,30,5,4\n";
    files.texts.erase("criteria.csv");
    const ValidationCase of =
        read_case(files, few_years(10, 10, 50, {"forest.canopy_death=0.0016", "forest.regeneration=no"}));
    ASSERT_FALSE(of.notes.empty());
    EXPECT_EQ(of.notes.front(),
              "not the defaults of a run: forest.canopy_death = 0.0016, forest.regeneration = no");
    EXPECT_FALSE(forest_cases::changes_a_law(read_case(files, few_years(10, 10, 50))));
    EXPECT_FALSE(forest_cases::changes_a_law(read_case(belts_at(two_sites), few_years(10, 5, 30))));
}

TEST(YearsCase, NamesTheLineOfASiteWhoseScenarioIsRefused) {
    CaseFiles files = belts_at("");
    files.texts["sites.csv"] = "site,words,soil.typ\na,here,1\n";
    EXPECT_EQ(problem_of(files, few_years(10, 5, 30)).find("validation/forest_belts/sites.csv:2:8: found "),
              0U)
        << problem_of(files, few_years(10, 5, 30));
    files = belts_at(two_sites);
    replace(files.texts["scenario.ini"], "file = climate.csv", "file = weather.csv");
    EXPECT_TRUE(problem_of(files, few_years(10, 5, 30))
                    .ends_with("; seen at site 'e0500', validation/forest_belts/sites.csv, line 2"))
        << problem_of(files, few_years(10, 5, 30));
}

TEST(YearsCase, RefusesASettingWithoutEnd) {
    const CaseFiles files = belts_at("a,here,500," + std::string(5000, '1') + "\n");
    EXPECT_EQ(problem_of(files, few_years(10, 5, 30)).find("validation/forest_belts/sites.csv:2:"), 0U);
    EXPECT_LT(problem_of(files, few_years(10, 5, 30)).size(), 400U);
}

TEST(YearsCase, AsksTheChecksOfItsFolderBeforeAnythingIsSimulated) {
    CaseFiles files = belts_at(two_sites);
    files.texts["mine.csv"] = "name,size\na,1\nb,30\n# or\nc,40\n";
    files.texts["figures.sql"] =
        "-- warning mine.csv | more than {size_m} m\nSELECT line, 20 AS size_m FROM mine WHERE size > 20;\n";
    const std::vector<std::string> warnings = read_case(files, few_years(10, 5, 30)).warnings;
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(std::find(warnings.begin(), warnings.end(),
                        "validation/forest_belts/mine.csv, lines 3, 5: more than 20 m"),
              warnings.end())
        << warnings.front();
    files.texts["figures.sql"] +=
        "-- error mine.csv | {name} of {size} m | 35 m or less\nSELECT line, name, size FROM mine WHERE size "
        "> 35;\n";
    files.texts["mine.csv"] = "name,size\na,1\n";
    EXPECT_EQ(problem_of(files, few_years(10, 5, 30)), "");
}

TEST(YearsCase, DividesFiguresThatAreWholeNumbers) {
    CaseFiles files = belts_at(two_sites);
    files.texts["figures.sql"] =
        "-- figure three:{site} | sites | three | -\nSELECT 3;\n"
        "-- figure half:{site} | sites | half | -\n"
        "SELECT value / 2 FROM figures WHERE figure = 'three:' || :site;\n";
    EXPECT_EQ(value_of(result_of(files, few_years(10, 10, 30)), "half:e0500"), 1.5);
}

TEST(YearsCase, DrawsLinesAndDotsWithTheirLabels) {
    CaseFiles files = belts_at(two_sites);
    files.texts["figures.sql"] =
        "-- lines Growth\nSELECT words, regime, 'line', 'here', year AS \"Years\", volume_m3pha AS "
        "\"m3/ha\"\n"
        "FROM stands JOIN sites USING (site) WHERE stand = 'all' AND species = 'all' ORDER BY site, year;\n";
    const CaseResult result = result_of(files, few_years(10, 10, 30));
    const auto group = std::find_if(result.plots.begin(), result.plots.end(),
                                    [](const PlotGroup& one) { return one.title == "Growth"; });
    ASSERT_NE(group, result.plots.end());
    ASSERT_EQ(group->plots.size(), 2U);
    EXPECT_EQ(group->plots[0].title, "500 m");
    EXPECT_EQ(group->plots[0].x.title, "Years");
    ASSERT_EQ(group->plots[0].series.size(), 1U);
    EXPECT_EQ(group->plots[0].series[0].points.size(), 2U) << "states of every tenth year";
    ASSERT_EQ(group->plots[0].labels.size(), 1U);
    EXPECT_EQ(group->plots[0].labels[0].x, 10.0) << "at the end of its line";
    replace(files.texts["figures.sql"], "'line'", "'wave'");
    EXPECT_THROW(static_cast<void>(result_of(files, few_years(10, 10, 30))), config::InputError);
}

TEST(YearsCase, WarnsOfATableThatNeitherScenarioNorQueryReads) {
    CaseFiles files = belts_at(two_sites);
    files.texts["expect.csv"] = "site\n";
    const ValidationCase of = read_case(files, few_years(10, 5, 30));
    EXPECT_TRUE(std::any_of(of.warnings.begin(), of.warnings.end(), [](const std::string& warning) {
        return warning.find("expect.csv is not read") != std::string::npos;
    }));
}

}  // namespace
}  // namespace coupling::validation::years_case_test
