#include "coupling/inputs/plausible/share_on_terrain.hpp"

#include <gtest/gtest.h>

#include "config/geometry/wkt.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::plausible::share_on_terrain_test {
namespace {

/// Of the terrain of the sample project, from 1005, 2005 to 1115, 2095.
OnTerrain on_sample(const std::string& wkt) {
    const SampleProject project;
    const Opened opened = open(project);
    return on_terrain(config::read_wkt(wkt, {}), opened.site->slope.terrain);
}

TEST(OnTerrain, IsTheShareOfTheAreaOfPolygonsWithTheirHoles) {
    const OnTerrain half = on_sample("POLYGON ((995 2030, 1015 2030, 1015 2070, 995 2070, 995 2030))");
    EXPECT_NEAR(half.share, 0.5, 0.01);
    EXPECT_NEAR(half.size, 800.0, 8.0);
    // The hole takes the quarter of the area that lies on the terrain to the west of 1010.
    const OnTerrain holed = on_sample(
        "POLYGON ((995 2030, 1015 2030, 1015 2070, 995 2070, 995 2030),"
        "(1005 2030, 1010 2030, 1010 2070, 1005 2070, 1005 2030))");
    EXPECT_NEAR(holed.share, 1.0 / 3.0, 0.02);
    EXPECT_EQ(on_sample("POLYGON ((1020 2030, 1030 2030, 1030 2040, 1020 2040, 1020 2030))").share, 1.0);
}

TEST(OnTerrain, IsTheShareOfTheLengthOfLinesAndOfTheNumberOfPoints) {
    EXPECT_NEAR(on_sample("LINESTRING (1105 2010, 1105 2190)").share, 85.0 / 180.0, 0.002);
    EXPECT_NEAR(on_sample("MULTILINESTRING ((1050 2010, 1050 2020), (1050 3010, 1050 3040))").share, 0.25,
                0.002);
    EXPECT_EQ(on_sample("MULTIPOINT (1050 2010, 1050 3010, 900 2000, 1060 2020)").share, 0.5);
}

/// Whether a shape touches the terrain of the sample project.
bool touches_sample(const std::string& wkt) {
    const SampleProject project;
    const Opened opened = open(project);
    const rockfall::Terrain& terrain = opened.site->slope.terrain;
    return touches_terrain(config::read_wkt(wkt, {}), terrain, extent_of(terrain));
}

TEST(TouchesTerrain, SeesAShortWayOfALongLine) {
    // 200 km, of which 14 m cross the north-western corner at 1005, 2095.
    const std::string line = "LINESTRING (-98990 -97915, 101010 102085)";
    EXPECT_EQ(on_sample(line).share, 0.0) << "too short for samples along all of it";
    EXPECT_TRUE(touches_sample(line));
    EXPECT_FALSE(touches_sample("LINESTRING (-99010 -97895, 100990 102105)"));  // 20 m further out
}

TEST(TouchesTerrain, SeesAreasAroundAndBesideTheTerrain) {
    EXPECT_TRUE(touches_sample("POLYGON ((0 0, 9000 0, 9000 9000, 0 9000, 0 0))"));
    // A hole around the terrain.
    EXPECT_FALSE(
        touches_sample("POLYGON ((0 0, 9000 0, 9000 9000, 0 9000, 0 0),"
                       "(900 1900, 1300 1900, 1300 2200, 900 2200, 900 1900))"));
    EXPECT_FALSE(touches_sample("POLYGON ((1200 2030, 1215 2030, 1215 2070, 1200 2070, 1200 2030))"));
    EXPECT_TRUE(touches_sample("MULTIPOINT (1050 2010, 5050 3010)"));
    EXPECT_FALSE(touches_sample("MULTIPOINT (1050 1010, 5050 3010)"));
}

TEST(PercentInWords, RoundsNeitherToNothingNorToAll) {
    EXPECT_EQ(percent_in_words(0.48), "48 %");
    EXPECT_EQ(percent_in_words(0.001), "less than 1 %");
    EXPECT_EQ(percent_in_words(0.999), "more than 99 %");
    EXPECT_EQ(percent_in_words(1.0), "100 %");
}

}  // namespace
}  // namespace coupling::plausible::share_on_terrain_test
