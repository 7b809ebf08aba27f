// Bad inputs of a forest: each is named with file, line, what was found and what was expected.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::forest_inputs_test {
namespace {

using config::ExitCode;

/// Opens a project that has to be refused with a sentence.
void expect_refused(const SampleProject& project, const std::vector<std::string>& overrides, ExitCode code,
                    const std::string& sentence) {
    const Opened opened = open(project, overrides);
    EXPECT_EQ(opened.code, code) << opened.errors;
    EXPECT_NE(opened.errors.find(sentence), std::string::npos) << opened.errors;
}

void expect_told(const SampleProject& project, const std::vector<std::string>& overrides,
                 const std::string& sentence) {
    const Opened opened = open(project, overrides);
    EXPECT_TRUE(opened.site) << opened.errors;
    std::string all;
    for (const std::string& warning : opened.warnings) {
        all += warning + "\n";
    }
    EXPECT_NE(all.find(sentence), std::string::npos) << all;
}

const std::vector<std::string> by_records{"trees.file=", "stands.records=records.csv"};

std::vector<std::string> and_also(std::vector<std::string> overrides, const std::string& one_more) {
    overrides.push_back(one_more);
    return overrides;
}

TEST(ForestSettings, TellAllThatMissesAtOnce) {
    const SampleProject project;
    const Opened opened = open(project, {"run.years=4"});
    EXPECT_EQ(opened.code, ExitCode::settings);
    EXPECT_EQ(
        opened.errors,
        "scenario.ini: found run.years above 0 without forest.latitude_deg, expected a number in [0, 75] "
        "deg\n"
        "scenario.ini: found run.years above 0 without a soil, expected soil.type, or soil.map with "
        "soil.types\n"
        "scenario.ini: found run.years above 0 without climate.file, expected a table of monthly climate");
}

TEST(ForestSettings, RefuseWhatIsOutOfRangeOrContradictsItself) {
    const ForestProject project;
    const auto refused = [&](const std::string& setting, const std::string& sentence) {
        expect_refused(project, {setting}, ExitCode::settings, sentence);
    };
    refused("forest.latitude_deg=91", "expected a number in [0, 75] deg");
    refused("stands.polygons=p.csv", "found stands.polygons beside stands.map, expected only one of them");
    refused("stands.records=records.csv",
            "found stands.records beside trees.file, expected only one of them");
    refused("soil.types=", "found soil.map without soil.types");
    refused("climate.co2_ppm=42", "expected 0 for the record, or a number in [100, 2000] ppm");
    refused(
        "output.tree_list_years=0 5",
        "found output.tree_list_years with year 5, but the run ends with year 4, expected whole years from 0 "
        "to 4, or run.years of 5");
    refused("output.map_years=1.5", "found output.map_years = '1.5', expected whole numbers in [0, 1000] yr");
    refused("terrain.dem=", "neither terrain.dem nor terrain.points");
    expect_refused(project, {"climate.temperature_change_k=2", "climate.change=c.csv"}, ExitCode::settings,
                   "found climate.change beside climate.temperature_change_k");
    expect_refused(project, {"climate.window_first_year=2005", "climate.window_last_year=2002"},
                   ExitCode::settings, "expected no year before climate.window_first_year 2005");
    expect_refused(project, {"run.years=0", "run.rockfall_every=0"}, ExitCode::settings,
                   "found neither rocks nor years");
    expect_refused(project, {"run.years=0", "run.replicates=3"}, ExitCode::settings,
                   "found run.replicates 3");
}

TEST(ForestSettings, TakeASoilOfTheirOwnTableEverywhere) {
    const ForestProject project;
    const Opened opened = open(project, {"soil.map=", "soil.type=2"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const ForestSite& site = *opened.site->forest;
    const Opened by_map = open(project);
    const forest::PatchGrid& mapped = by_map.site->forest->grid;
    const bool has_it = std::any_of(mapped.patches().begin(), mapped.patches().end(), [&](const auto& patch) {
        return patch.soil == site.grid.patches().front().soil;
    });
    EXPECT_TRUE(has_it) << "a row of soil.types";
    EXPECT_EQ(site.grid.patches().front().soil, site.grid.patches().back().soil);
    expect_refused(project, {"soil.map=", "soil.type=9"}, ExitCode::settings, "found soil.type '9'");
}

TEST(ForestSettings, ChooseTheFirstAndTheLastYearUnlessAsked) {
    EXPECT_EQ(chosen_years({}, 40), (std::vector<int>{0, 40}));
    EXPECT_EQ(chosen_years({20.0, 0.0, 20.0}, 40), (std::vector<int>{0, 20}));
}

TEST(ForestSpeciesInput, RefusesUnknownNamesInEachTable) {
    const ForestProject project;
    project.replace("trees.csv", "ABAL", "ABBL");
    expect_refused(project, {}, ExitCode::data,
                   "trees.csv:2:13: found species 'ABBL', expected a code or Latin name");
    project.replace("records.csv", "7,PIAB", "7,PIAX");
    expect_refused(project, by_records, ExitCode::data, "records.csv:2:3: found species 'PIAX'");
    expect_refused(project, and_also(by_records, "forest.region_species=PIAB, LADX"), ExitCode::settings,
                   "found species 'LADX', expected a code or Latin name of the species table (");
}

TEST(ForestSpeciesInput, LetsSpeciesStandInAndTells) {
    const ForestProject project;
    project.replace("records.csv", "7,ABAL", "7,TABA");
    expect_told(project, by_records, "records.csv: 1 row of TABA grow as Abies alba, which stands in for it");
}

TEST(ForestSpeciesInput, KnowsTheSpeciesOfTheRegion) {
    const ForestProject project;
    const Opened opened = open(project, and_also(by_records, "forest.region_species=abal; Fagus_x"));
    EXPECT_EQ(opened.code, ExitCode::settings);
    const Opened two = open(project, and_also(by_records, "forest.region_species=abal, FASY"));
    ASSERT_TRUE(two.site) << two.errors;
    const ForestSite& site = *two.site->forest;
    ASSERT_EQ(site.parameters.regeneration.outside.species.size(), 2U);
    EXPECT_EQ(site.species.table[site.parameters.regeneration.outside.species[1]].code, "FASY");
}

TEST(ForestSpeciesInput, RefusesAnOwnTableWithoutAColumnOrWithAValueOutOfRange) {
    const ForestProject project;
    const std::string shipped{config::shipped_table("species.csv")};
    project.write("species.csv", shipped);
    EXPECT_TRUE(open(project, {"forest.species=species.csv"}).site);
    project.replace("species.csv", "max_height", "tallest");
    expect_refused(project, {"forest.species=species.csv"}, ExitCode::data,
                   "species.csv: no column 'max_height");
    project.write("species.csv", shipped);
    project.replace("species.csv", "ABAL,", "fir?,");
    expect_refused(project, {"forest.species=species.csv"}, ExitCode::data,
                   "species.csv: found species 'fir?' without a known strength against rocks");
}

TEST(TreesOfAForest, OnOneSpotAreTold) {
    const ForestProject project;
    project.write(
        "trees.csv",
        "tree_id,x_m,y_m,species,dbh_cm,height_m\n1,1060,2050,ABAL,30,25\n2,1060,2050,PIAB,30,25\n");
    expect_told(project, {}, "trees.csv: 1 tree on the same spot as another");
    expect_told(project, {"run.years=0"}, "trees.csv: 1 tree on the same spot as another");
}

TEST(TreesOfAForest, WithWordsForNumbersAreNumberedByRow) {
    const ForestProject project;
    project.write(
        "trees.csv",
        "tree_id,x_m,y_m,species,dbh_cm,height_m\nA7,1060,2050,ABAL,30,25\nB2,1061,2050,PIAB,30,25\n");
    expect_told(project, {},
                "trees.csv: tree_id are not different whole numbers; trees are numbered as the rows");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->listed[1].id, forest::TreeId{2});
}

TEST(TreesOfAForest, MayLackAllHeights) {
    const ForestProject project;
    project.write("trees.csv", "x_m,y_m,species,dbh_cm\n1060,2050,ABAL,30\n1030,2050,PIAB,30\n");
    expect_told(project, {}, "Abies alba: 1 heights filled in from the growth law of the species");
    expect_told(project, {}, "trees.csv: 1 height of trees outside the forest filled in from the growth law");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_GT(opened.site->forest->obstacles[0].stem.height_m, 10.0);
    EXPECT_LT(opened.site->forest->obstacles[0].stem.height_m, 35.0);
}

TEST(StandRecords, AreRefusedWhereTheyLackOrContradict) {
    const ForestProject project;
    const auto refused = [&](const std::string& row, const std::string& sentence) {
        project.write("records.csv",
                      "stand,species,stems_pha,basal_area_m2pha,mean_dbh_cm,mean_height_m,structure\n8,PIAB,"
                      "100,,20,,\n" +
                          row + "\n");
        expect_refused(project, by_records, ExitCode::data, sentence);
    };
    refused("7,PIAB,,,25,,", "records.csv:3:1: found neither stems nor basal area");
    refused("7,PIAB,600,,,,", "records.csv:3:1: found no mean diameter");
    refused(
        "7,PIAB,600,40,25,,",
        "records.csv:3:1: found stems_pha 600 with mean_dbh_cm 25 make 29.5 m2/ha, not basal_area_m2pha 40, "
        "expected two of the three, or three that agree within 10 %");
    refused("7,PIAB,5,60,,,",
            "found a mean diameter of 390.9 cm, expected at least 1 cm and less than the greatest");
    refused("7,PIAB,600,,25,90,",
            "found mean_height_m 90, expected at most the greatest height of Picea abies");
    refused("8,FASY,600,,25,,groups", "found another structure of stand 8 than in its first row");
}

TEST(StandRecords, AgreeWithTheStandsOfTheMap) {
    const ForestProject project;
    project.replace("records.csv", "8,FASY", "9,FASY");
    const Opened opened = open(project, by_records);
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_EQ(
        opened.errors,
        "records.csv: found no record of stand 8, expected one for each stand of the map; stems_pha 0 where "
        "there are no trees\n"
        "records.csv:4:1: found stand 9 which is not on the map, expected a stand of stands.asc");
}

TEST(StandPolygons, OutsideTheTerrainAreDoubted) {
    const ForestProject project;
    project.write("polygons.csv",
                  "stand,wkt\n7,\"POLYGON ((1050 2010, 1110 2010, 1110 2090, 1050 2090, 1050 2010))\"\n"
                  "8,\"POLYGON ((5050 2010, 5110 2010, 5110 2090, 5050 2090, 5050 2010))\"\n");
    const std::vector<std::string> by_polygons{"stands.map=", "stands.polygons=polygons.csv"};
    expect_told(project, by_polygons,
                "polygons.csv: found 1 stand without a forest cell on the terrain, such as 8");
    const Opened opened = open(project, by_polygons);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->grid.size(), 48U);
    expect_refused(project, and_also(by_polygons, "run.strict_inputs=yes"), ExitCode::data, "such as 8");
}

TEST(StandMap, HoldsWholeNumbers) {
    const ForestProject project;
    project.replace("stands.asc", "7", "7.5");
    expect_refused(project, {}, ExitCode::data, "stands.asc: found stand number 7.5 in row 1, column 5");
}

TEST(StandMap, LeavesOutForestWithoutGround) {
    const ForestProject project;
    project.write("dem.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                 return column == 11 && row == 9 ? "-9999" : std::to_string(400 - 7 * column);
                             }));
    project.write("surface.asc", SampleProject::header() + SampleProject::rows([](int, int) { return "1"; }));
    // The cell itself and its neighbours: none of them has heights everywhere.
    expect_told(project, {}, "dem.asc: 4 forest cells of 10 m without ground everywhere; left out");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->grid.size(), 76U);
}

TEST(Soils, NeedATypeForEachCodeAndACodeForEachPatch) {
    const ForestProject project;
    project.replace("soils.csv", "2,120", "3,120");
    expect_refused(project, {}, ExitCode::data,
                   "soil.asc: found soil code 2 in 40 cells, the first in row 1, column 9");
    project.replace("soils.csv", "3,120", "2,120");
    project.write("soil.asc",
                  SampleProject::header() + "NODATA_value 0\n" +
                      SampleProject::rows([](int column, int) { return column < 8 ? "0" : "2"; }));
    expect_refused(project, {}, ExitCode::data, "soil.asc: found no soil code for 40 forest cells of 10 m");
    const Opened filled = open(project, {"soil.type=shallow"});
    ASSERT_TRUE(filled.site) << filled.errors;
    const forest::PatchGrid& grid = filled.site->forest->grid;
    EXPECT_EQ(grid[*grid.at(1045.0, 2045.0)].soil.fertility, 0.4);
    expect_refused(project, {"soil.type=loam"}, ExitCode::settings,
                   "found soil.type 'loam', expected one of scree, shallow, normal, deep");
}

}  // namespace
}  // namespace coupling::forest_inputs_test
