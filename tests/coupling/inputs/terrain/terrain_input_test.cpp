#include "coupling/inputs/terrain/terrain_input.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::terrain_input_test {
namespace {

TEST(Heights, ReadTheSameFromAPackedGrid) {
    const SampleProject project;
    const Opened plain = open(project);
    ASSERT_EQ(std::system(("gzip --keep '" + project.file("dem.asc").string() + "'").c_str()), 0);
    const Opened unpacked = open(project, {"terrain.dem=dem.asc.gz"});
    ASSERT_TRUE(plain.site && unpacked.site) << unpacked.errors;
    EXPECT_EQ(unpacked.site->heights.values, plain.site->heights.values);
    EXPECT_EQ(unpacked.site->projection, plain.site->projection);
}

TEST(Heights, OfGroundThatComesDownToZeroAreNone) {
    const SampleProject project;
    project.write("dem.asc", SampleProject::header() + SampleProject::rows([](int column, int) {
                                 return column == 11 ? "0" : std::to_string(22 * (11 - column) - 14);
                             }));
    for (const std::string& warning : open(project).warnings) {
        EXPECT_EQ(warning.find("of height 0"), std::string::npos) << warning;
    }
}

TEST(Points, ReadInAnyCommonForm) {
    for (const std::string text :
         {"1 2 3\n4 5 6\n", "x,y,z\n1,2,3\n4,5,6", "# survey\n1;2;3\r\n\n\t4 5  6 # last\n"}) {
        const std::vector<Eigen::Vector3d> points = read_points(text, "points.xyz");
        ASSERT_EQ(points.size(), 2U) << text;
        EXPECT_EQ(points[1], Eigen::Vector3d(4.0, 5.0, 6.0));
    }
}

TEST(Points, MakeATerrainWithItsOwnMapFrame) {
    const SampleProject project;
    std::ostringstream points;
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 12; ++column) {
            points << 1005 + 10 * column << ' ' << 2005 + 10 * row << ' ' << 400 - 7 * column << '\n';
        }
    }
    project.write("points.xyz", points.str());
    project.write("cliff.csv", "zone,wkt\n4,\"LINESTRING (1020 2030, 1020 2060)\"\n");
    project.write("scenario.ini",
                  "[terrain]\npoints = points.xyz\nground = forest_soil_deep\n"
                  "[release]\nsource_shapes = cliff.csv\nrocks = 7\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const Site& site = *opened.site;
    EXPECT_EQ(site.map_frame.cell_width_m, 10.0);  // the mean spacing is a little less
    EXPECT_EQ(site.map_frame.columns, 11);
    EXPECT_EQ(site.slope.types.front().label, "forest soil (deep)");
    ASSERT_EQ(site.sources.size(), 1U);
    EXPECT_EQ(site.sources[0].zone, 4U);
    EXPECT_EQ(site.sources[0].rocks, 7U);
    EXPECT_NEAR(
        site.heights.at(site.map_frame.cell_at(1051.0, 2051.0)),
        400.0 - 0.7 * (site.map_frame.x_centre_m(site.map_frame.cell_at(1051.0, 2051.0).column) - 1005.0),
        1e-9);
}

TEST(MapFrame, CoversTheExtentFromTheSameCorner) {
    const config::GridFrame dem{.columns = 10,
                                .rows = 6,
                                .x_west_m = 3.0,
                                .y_south_m = 4.0,
                                .cell_width_m = 5.0,
                                .cell_height_m = 5.0};
    EXPECT_EQ(with_cell_size(dem, 0.0), dem);
    const config::GridFrame finer = with_cell_size(dem, 2.5);
    EXPECT_EQ(finer.columns, 20);
    EXPECT_EQ(finer.rows, 12);
    const config::GridFrame odd = with_cell_size(dem, 4.0);
    EXPECT_EQ(odd.columns, 13);
    EXPECT_EQ(odd.x_west_m, 3.0);
    EXPECT_GE(odd.x_east_m(), dem.x_east_m());
    EXPECT_GE(odd.y_north_m(), dem.y_north_m());
}

}  // namespace
}  // namespace coupling::terrain_input_test
