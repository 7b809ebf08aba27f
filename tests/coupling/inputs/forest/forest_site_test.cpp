#include "coupling/inputs/forest/forest_site.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::forest_site_test {
namespace {

using config::ExitCode;

bool has(const std::vector<std::string>& sentences, const std::string& part) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
}

TEST(ForestSite, LaysPatchesOnTheGroundOfTheStands) {
    const ForestProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ForestSite& site = *opened.site->forest;
    EXPECT_EQ(site.grid.size(), 80U);
    // The slope falls by 7 m with each 10 m eastwards.
    const auto patch = site.grid.at(1065.0, 2055.0);
    ASSERT_TRUE(patch);
    EXPECT_NEAR(site.grid[*patch].ground_m, 400.0 - 42.0, 1e-9);
    EXPECT_NEAR(site.grid[*patch].slope.in_degrees(), 34.992, 1e-3);
    EXPECT_NEAR(site.grid[*patch].aspect.in_degrees(), 90.0, 1e-6);
    EXPECT_EQ(site.grid[*patch].management_unit, 7U);
    EXPECT_EQ(site.grid[*patch].soil.water_capacity_mm, 70.0);
    EXPECT_EQ(site.grid[*site.grid.at(1095.0, 2045.0)].management_unit, 8U);
    EXPECT_EQ(site.grid[*site.grid.at(1095.0, 2045.0)].soil.ph, 5.5);
    EXPECT_FALSE(site.grid.at(1035.0, 2055.0));
}

const std::vector<std::string> plot{"terrain.dem=",
                                    "stands.map=",
                                    "soil.map=",
                                    "soil.types=",
                                    "soil.type=normal",
                                    "trees.file=",
                                    "terrain.plane_width_m=40",
                                    "terrain.plane_length_m=60",
                                    "terrain.plane_elevation_m=1500",
                                    "run.rockfall_every=0"};

std::vector<std::string> plot_with(std::vector<std::string> more) {
    more.insert(more.begin(), plot.begin(), plot.end());
    return more;
}

TEST(ForestSite, StartsTheSameWhateverEventsAreAskedForLater) {
    const ForestProject project;
    const std::vector<std::string> usual{"trees.file=", "stands.records=records.csv",
                                         "climate.sequence=random", "disturbance.beetle=yes",
                                         "stands.spin_up_years=6"};
    const auto start_with = [&](const std::vector<std::string>& events) {
        std::vector<std::string> settings = usual;
        settings.insert(settings.end(), events.begin(), events.end());
        const Opened opened = open(project, settings);
        EXPECT_TRUE(opened.site) << opened.errors;
        return opened.site->forest->start(1, 0);
    };
    const forest::Stand calm = start_with({});
    ASSERT_FALSE(calm.cohorts().empty());
    for (const std::vector<std::string>& events : std::vector<std::vector<std::string>>{
             {"disturbance.storm_years=2002", "disturbance.storm_years_intensity=1"},
             {"disturbance.beetle_years=2001,2002", "disturbance.beetle_years_pha=0.99"},
             {"climate.dry_years=2001,2002,2003", "climate.dry_season_precipitation=0.1"}}) {
        const forest::Stand stand = start_with(events);
        EXPECT_EQ(stand.dead_wood_kg(), calm.dead_wood_kg()) << events.front();
        EXPECT_EQ(stand.dead_wood().logs.size(), calm.dead_wood().logs.size()) << events.front();
        ASSERT_EQ(stand.cohorts().size(), calm.cohorts().size()) << events.front();
        for (std::size_t i = 0; i < calm.cohorts().size(); ++i) {
            EXPECT_EQ(stand.cohorts()[i].height_m, calm.cohorts()[i].height_m) << events.front();
        }
    }
}

TEST(ForestSite, NeedsNoMapOnAPlane) {
    const ForestProject project;
    const Opened level = open(project, plot);
    ASSERT_TRUE(level.site) << level.errors;
    EXPECT_EQ(level.site->forest->grid.size(), 24U);
    EXPECT_EQ(level.site->forest->grid.patches().front().ground_m, 1500.0);
    const Opened steep =
        open(project, plot_with({"terrain.plane_slope_deg=30", "terrain.plane_aspect_deg=225"}));
    ASSERT_TRUE(steep.site) << steep.errors;
    double sum_m = 0.0;
    for (const forest::Patch& patch : steep.site->forest->grid.patches()) {
        EXPECT_NEAR(patch.slope.in_degrees(), 30.0, 1e-6);
        EXPECT_NEAR(patch.aspect.in_degrees(), 225.0, 1e-6);
        sum_m += patch.ground_m / 24.0;
    }
    EXPECT_NEAR(sum_m, 1500.0, 1e-6) << "the height is that of the middle";
}

TEST(ForestSite, GoesOnAsAtTheOppositeSideWithPeriodicEdges) {
    const ForestProject project;
    const Opened opened = open(project, plot_with({"forest.edges=periodic", "terrain.plane_slope_deg=45",
                                                   "terrain.plane_aspect_deg=90"}));
    ASSERT_TRUE(opened.site) << opened.errors;
    const forest::LightSite& light = opened.site->forest->place.light();
    EXPECT_EQ(light.edges(), forest::Edges::torus);
    // The plane falls eastwards by its width: the column beyond the eastern border goes on falling.
    const forest::PaddedGround& ground = light.ground();
    const std::size_t east = ground.padded(3);
    EXPECT_NEAR(ground.elevation_m()[east] - ground.elevation_m()[east + 1], 10.0, 1e-4);
    EXPECT_EQ(ground.source(east + 1), 0U) << "trees of the western border";
}

TEST(ForestSite, GrowsTheTreesOfAListAndLeavesTheOthersStanding) {
    const ForestProject project;
    project.write("trees.csv",
                  "tree_id,x_m,y_m,species,dbh_cm,height_m\n"
                  "12,1060,2050,ABAL,32.5,25\n11,1070,2042,piab,20,18\n3,1030,2061,Fagus sylvatica,41,28\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const ForestSite& site = *opened.site->forest;
    const forest::Stand stand = site.start(1, 0);
    ASSERT_EQ(stand.trees().size(), 2U);
    EXPECT_EQ(stand.trees()[0].id, forest::TreeId{11});
    EXPECT_EQ(stand.trees()[1].id, forest::TreeId{12});
    ASSERT_EQ(site.obstacles.size(), 1U);
    EXPECT_EQ(site.obstacles[0].id, "3");
    EXPECT_EQ(site.obstacles[0].species, "FASY");
    EXPECT_EQ(site.obstacles[0].stem.fracture_energy, 1.70);
    EXPECT_TRUE(opened.site->trees.empty());
    EXPECT_TRUE(has(opened.warnings, "trees.csv: 1 tree outside the forest: obstacles that do not grow"));
}

TEST(ForestSite, LivesThroughItsYears) {
    const ForestProject project;
    const Opened opened = open(project, {"trees.file=", "stands.records=records.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const ForestSite& site = *opened.site->forest;
    forest::Stand stand = site.start(1, 0);
    EXPECT_EQ(stand.year(), 2000);
    const std::uint64_t stems = stand.stems_standing();
    // 0.4 ha with 600 spruces and 5 m2/ha of firs of 20 cm (159), 0.4 ha with 400 beeches, each per hectare.
    EXPECT_EQ(stems, 240U + 64U + 160U);
    for (int year = 0; year < 4; ++year) {
        const YearWeather weather = site.weather(0, stand.year() + 1, 0);
        const forest::YearReport report =
            forest::grow_year(stand, site.place, site.species.table, weather.view(), site.parameters, {1, 0});
        EXPECT_GT(report.production_kg, 0.0);
    }
    EXPECT_EQ(stand.year(), 2004);
}

TEST(ForestSite, PlacesAnInventoryAnewInEachReplicate) {
    const ForestProject project;
    const Opened opened = open(project, {"trees.file=", "stands.records=records.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const ForestSite& site = *opened.site->forest;
    const forest::Stand first = site.start(1, 0);
    EXPECT_EQ(site.start(1, 0).trees()[10].x_m, first.trees()[10].x_m);
    EXPECT_NE(site.start(1, 1).trees()[10].x_m, first.trees()[10].x_m);
    EXPECT_EQ(site.start(1, 1).trees()[10].dbh_cm, first.trees()[10].dbh_cm);
}

TEST(ForestSite, BeginsOnBareGroundWhereNobodySaysWhatGrows) {
    const ForestProject project;
    const Opened opened = open(project, {"trees.file="});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(opened.site->forest->start(1, 0).trees().empty());
    EXPECT_TRUE(has(opened.warnings, "the forest begins on bare ground"));
}

TEST(ForestSite, NeedsNoRocksWhereNoneFall) {
    const ForestProject project;
    const Opened opened = open(
        project, {"run.rockfall_every=0", "release.source=", "terrain.surface=", "terrain.surface_types="});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(opened.site->sources.empty());
    EXPECT_EQ(opened.site->forest->grid.size(), 80U);
    EXPECT_EQ(opened.site->heights.values.size(), 120U);
}

}  // namespace
}  // namespace coupling::forest_site_test
