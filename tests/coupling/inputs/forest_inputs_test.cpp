// How inputs of a forest are taken; what is refused of them stands in tests/refusals/forest.cases.

#include <gtest/gtest.h>

#include <algorithm>

#include "coupling/inputs/scenario/forest_settings.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::forest_inputs_test {
namespace {

const std::vector<std::string> by_records{"trees.file=", "stands.records=records.csv"};

std::vector<std::string> and_also(std::vector<std::string> overrides, const std::string& one_more) {
    overrides.push_back(one_more);
    return overrides;
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
}

TEST(ForestSettings, ChooseTheFirstAndTheLastYearUnlessAsked) {
    EXPECT_EQ(chosen_years({}, 40), (std::vector<int>{0, 40}));
    EXPECT_EQ(chosen_years({20.0, 0.0, 20.0}, 40), (std::vector<int>{0, 20}));
}

TEST(ForestSpeciesInput, KnowsTheSpeciesOfTheRegion) {
    const ForestProject project;
    const Opened two = open(project, and_also(by_records, "forest.region_species=abal, FASY"));
    ASSERT_TRUE(two.site) << two.errors;
    const ForestSite& site = *two.site->forest;
    ASSERT_EQ(site.parameters.regeneration.outside.species.size(), 2U);
    EXPECT_EQ(site.species.table[site.parameters.regeneration.outside.species[1]].code, "FASY");
}

TEST(TreesOfAForest, WithWordsForNumbersAreNumberedByRow) {
    const ForestProject project;
    project.write(
        "trees.csv",
        "tree_id,x_m,y_m,species,dbh_cm,height_m\nA7,1060,2050,ABAL,30,25\nB2,1061,2050,PIAB,30,25\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->listed[1].id, forest::TreeId{2});
}

TEST(TreesOfAForest, MayLackAllHeights) {
    const ForestProject project;
    project.write("trees.csv", "x_m,y_m,species,dbh_cm\n1060,2050,ABAL,30\n1030,2050,PIAB,30\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_GT(opened.site->forest->obstacles[0].stem.height_m, 10.0);
    EXPECT_LT(opened.site->forest->obstacles[0].stem.height_m, 35.0);
}

TEST(StandPolygons, OutsideTheTerrainAreLeftOut) {
    const ForestProject project;
    project.write("polygons.csv",
                  "stand,wkt\n7,\"POLYGON ((1050 2010, 1110 2010, 1110 2090, 1050 2090, 1050 2010))\"\n"
                  "8,\"POLYGON ((5050 2010, 5110 2010, 5110 2090, 5050 2090, 5050 2010))\"\n");
    const std::vector<std::string> by_polygons{"stands.map=", "stands.polygons=polygons.csv"};
    const Opened opened = open(project, by_polygons);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->grid.size(), 48U);
}

TEST(StandMap, LeavesOutForestWithoutGround) {
    const ForestProject project;
    project.write("dem.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                 return column == 11 && row == 9 ? "-9999" : std::to_string(400 - 7 * column);
                             }));
    project.write("surface.asc", SampleProject::header() + SampleProject::rows([](int, int) { return "1"; }));
    // The cell itself and its neighbours: none of them has heights everywhere.
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->forest->grid.size(), 76U);
}

TEST(Soils, AreThatOfTheSettingWhereTheMapHasNone) {
    const ForestProject project;
    project.write("soil.asc",
                  SampleProject::header() + "NODATA_value 0\n" +
                      SampleProject::rows([](int column, int) { return column < 8 ? "0" : "2"; }));
    const Opened filled = open(project, {"soil.type=shallow"});
    ASSERT_TRUE(filled.site) << filled.errors;
    const forest::PatchGrid& grid = filled.site->forest->grid;
    EXPECT_EQ(grid[*grid.at(1045.0, 2045.0)].soil.fertility, 0.4);
}

}  // namespace
}  // namespace coupling::forest_inputs_test
