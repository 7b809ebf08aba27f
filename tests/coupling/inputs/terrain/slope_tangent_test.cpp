#include "coupling/inputs/terrain/slope_tangent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/terrain/mesh.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::slope_tangent_test {
namespace {

HeightInput input_of(const config::Raster<double>& grid) {
    HeightInput heights;
    heights.grid = grid;
    heights.map_frame = grid.frame;
    return heights;
}

config::Raster<double> grid_of(double (*height_m)(double, double)) {
    config::Raster<double> grid{{7, 6, 0.0, 0.0, 5.0, 5.0}};
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        const config::Cell cell = grid.frame.cell_of(i);
        grid.values[i] = height_m(grid.frame.x_centre_m(cell.column), grid.frame.y_centre_m(cell.row));
    }
    return grid;
}

double tangent_at(const config::Raster<double>& grid, config::Cell cell) {
    const rockfall::Terrain terrain = rockfall::triangulate(grid, 0.0);
    return slope_tangent(input_of(grid), grid.frame, terrain, grid.frame.index(cell)).value();
}

TEST(SlopeTangent, OfAPlaneIsThatOfThePlaneAtBordersToo) {
    const config::Raster<double> plane =
        grid_of([](double x, double y) { return 900.0 - 0.3 * x + 0.4 * y; });
    for (const config::Cell cell : {config::Cell{3, 3}, {0, 0}, {6, 2}}) {
        EXPECT_NEAR(tangent_at(plane, cell), 0.5, 1e-9);
    }
}

TEST(SlopeTangent, IsHornsOnRoughGround) {
    const config::Raster<double> rough =
        grid_of([](double x, double y) { return 900.0 - 0.6 * x + 3.0 * std::sin(x) * std::cos(0.7 * y); });
    const auto z = [&](int column, int row) { return rough.at({column, row}); };
    // ((c + 2f + i) - (a + 2d + g)) / 8 cells, and the same across (Horn 1981).
    const double east = ((z(4, 2) + 2 * z(4, 3) + z(4, 4)) - (z(2, 2) + 2 * z(2, 3) + z(2, 4))) / 40.0;
    const double north = ((z(2, 2) + 2 * z(3, 2) + z(4, 2)) - (z(2, 4) + 2 * z(3, 4) + z(4, 4))) / 40.0;
    EXPECT_NEAR(tangent_at(rough, {3, 3}), std::hypot(east, north), 1e-9);
}

TEST(SlopeTangent, IsThatOfTheFaceOnPoints) {
    HeightInput heights;
    heights.points = {{0, 0, 100}, {50, 0, 70}, {0, 50, 100}, {50, 50, 70}};
    heights.map_frame = {5, 5, 0.0, 0.0, 10.0, 10.0};
    const rockfall::Terrain terrain = rockfall::triangulate(heights.points, 0.0);
    EXPECT_NEAR(slope_tangent(heights, heights.map_frame, terrain, 12).value(), 0.6, 1e-9);
}

std::vector<int> codes_by_column(const Opened& opened) {
    std::vector<int> codes;
    for (int column = 1; column < 11; ++column) {
        codes.push_back(opened.site->slope.types[opened.site->surface.at({column, 5})].code);
    }
    return codes;
}

/// A project whose slope is 35 degrees to the sixth column and 11 degrees beyond.
SampleProject& bend(SampleProject& project) {
    project.write("dem.asc",
                  SampleProject::header() + SampleProject::rows([](int column, int) {
                      return std::to_string(column < 6 ? 400 - 7 * column : 365 - 2 * (column - 5));
                  }));
    return project;
}

TEST(SlopeGrounds, LieWhereNoMapSays) {
    SampleProject project;
    bend(project);
    project.write("classes.csv", "from_deg,surface\n0,3\n25,1\n");
    const Opened opened = open(project, {"terrain.surface=", "terrain.slope_grounds=classes.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    // 24.2 degrees on the bend itself: (7 + 2) / 2 m over 10 m.
    EXPECT_EQ(codes_by_column(opened), (std::vector<int>{1, 1, 1, 1, 3, 3, 3, 3, 3, 3}));
}

TEST(SlopeGrounds, FillGapsOfTheMapAndMayBeShippedTypes) {
    SampleProject project;
    bend(project);
    project.write("surface.asc",
                  SampleProject::header() + "NODATA_value -9999\n" +
                      SampleProject::rows([](int column, int) { return column < 3 ? "-9999" : "3"; }));
    project.write("classes.csv", "from_deg,surface\n0,pasture\n30,solid_rock\n");
    const Opened opened = open(project, {"terrain.slope_grounds=classes.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const Site& site = *opened.site;
    EXPECT_EQ(site.slope.types[site.surface.at({1, 5})].label, "solid rock");
    EXPECT_EQ(site.slope.types[site.surface.at({1, 5})].code, 9);  // its row among the shipped types
    EXPECT_EQ(site.slope.types[site.surface.at({5, 5})].label, "soil");
}

TEST(SteepSources, AreAllSteepCellsInsideTheTerrain) {
    SampleProject project;
    bend(project);
    const Opened opened = open(project, {"release.source=", "release.steeper_than_deg=30"});
    ASSERT_TRUE(opened.site) << opened.errors;
    // Columns 1 to 4 of 8 inner rows; the outer ring is left out without a word, as nobody named it.
    EXPECT_EQ(opened.site->sources.size(), 32U);
    EXPECT_EQ(opened.warnings, std::vector<std::string>{});
    for (const rockfall::ReleaseSource& source : opened.site->sources) {
        EXPECT_EQ(source.zone, 1U);
        EXPECT_LE(source.last_m.x() + opened.site->origin_m().x(), 1050.0);
    }
}

TEST(SteepSources, WithinAGridOrPolygonsAreTheSteepOnes) {
    SampleProject project;
    bend(project);
    project.write("source.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                    return row == 5 && column > 2 && column < 9 ? "4" : "0";
                                }));
    const Opened grid = open(project, {"release.steeper_than_deg=30"});
    ASSERT_TRUE(grid.site) << grid.errors;
    ASSERT_EQ(grid.site->sources.size(), 2U);
    EXPECT_EQ(grid.site->sources[0].zone, 4U);
    project.write("area.csv", "wkt\n\"POLYGON ((1030 2040, 1090 2040, 1090 2050, 1030 2050, 1030 2040))\"\n");
    const Opened area =
        open(project, {"release.source=", "release.source_shapes=area.csv", "release.steeper_than_deg=30"});
    ASSERT_TRUE(area.site) << area.errors;
    EXPECT_EQ(area.site->sources.size(), 2U);
}

}  // namespace
}  // namespace coupling::slope_tangent_test
