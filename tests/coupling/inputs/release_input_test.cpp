#include "coupling/inputs/release_input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling {
namespace {

using config::ExitCode;

std::string source_grid(int column, int first_row, int last_row) {
    return SampleProject::header() + SampleProject::rows([=](int c, int r) {
               return c == column && r >= first_row && r <= last_row ? "1" : "0";
           });
}

std::uint64_t rocks_of(const Site& site) {
    return std::accumulate(site.sources.begin(), site.sources.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const rockfall::ReleaseSource& s) { return sum + s.rocks; });
}

TEST(SourceGrid, WeighsCellsByTheirTrueSurface) {
    const SampleProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 4U);
    // The slope rises 7 m in 10 m: 100 m2 in plan are 100 * sqrt(1 + 0.7^2) m2 of ground.
    EXPECT_NEAR(opened.site->sources[0].weight, 100.0 * std::sqrt(1.49), 1e-4);
    EXPECT_EQ(rocks_of(*opened.site), 20U);
    EXPECT_EQ(rocks_of(*open(project, {"release.rocks=33"}).site), 33U);
}

TEST(SourceGrid, OfAnotherFrameIsRefused) {
    const SampleProject project;
    project.replace("source.asc", "yllcorner 2000", "yllcorner 2005");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_EQ(
        opened.errors,
        "source.asc: found 12 x 10 cells of 10 m, corner 1000, 2005, expected the frame of dem.asc, 12 x 10 "
        "cells of 10 m, corner 1000, 2000");
}

TEST(SourceGrid, OnNodataIsRefused) {
    const SampleProject project;
    project.write("dem.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                 return column == 2 && row == 4 ? "-9999" : std::to_string(400 - 7 * column);
                             }));
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_EQ(opened.errors,
              "source.asc: found 1 source cell on NODATA of dem.asc, the first in row 5, column 3 (x 1025, y "
              "2055), "
              "expected heights all over the release area");
}

TEST(SourceGrid, InTheOuterRingIsLeftOutAndCounted) {
    const SampleProject project;
    project.write("source.asc", source_grid(2, 0, 4));
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->sources.size(), 4U);
    EXPECT_EQ(opened.warnings,
              std::vector<std::string>{
                  "source.asc: found 1 source cell of 5 in the outer ring of dem.asc, where the "
                  "terrain ends; left out, expected sources at least one cell inside"});
}

TEST(SourceGrid, WithoutAnySourceLeftIsRefused) {
    const SampleProject project;
    project.write("source.asc", source_grid(0, 0, 9));
    const Opened in_ring = open(project);
    EXPECT_EQ(in_ring.code, ExitCode::data);
    EXPECT_EQ(in_ring.errors,
              "source.asc: found no source of rocks that lies on the terrain, expected at least one cell "
              "above 0 inside "
              "the outer ring");
    project.write("source.asc", source_grid(-1, 0, 0));
    EXPECT_EQ(open(project).code, ExitCode::data);
}

TEST(SourceGrid, OfNumbersThatAreNoZonesIsRefused) {
    const SampleProject project;
    project.replace("source.asc", "1", "0.5");  // the header keeps no such word before the first zone
    EXPECT_EQ(open(project).code, ExitCode::data);
}

TEST(SourceShapes, ShareRocksByLength) {
    const SampleProject project;
    project.write(
        "cliffs.csv",
        "zone,wkt\n1,\"LINESTRING (1020 2030, 1020 2060)\"\n2,\"LINESTRING (1030 2030, 1030 2040)\"\n");
    const Opened opened =
        open(project, {"release.source=", "release.source_shapes=cliffs.csv", "release.rocks=40"});
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 2U);
    EXPECT_EQ(opened.site->sources[0].rocks, 30U);
    EXPECT_EQ(opened.site->sources[1].rocks, 10U);
    EXPECT_EQ(opened.site->sources[1].first_rock, 30U);
}

TEST(SourceShapes, OfPointsShareRocksEvenly) {
    const SampleProject project;
    project.write("points.csv", "wkt\nPOINT (1020 2050)\nPOINT (1030 2050)\nPOINT (900 2050)\n");
    const Opened opened = open(project, {"release.source=", "release.source_shapes=points.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 2U);
    EXPECT_EQ(opened.site->sources[0].rocks, 5U);
    EXPECT_EQ(opened.site->sources[0].first_m, opened.site->sources[0].last_m);
    EXPECT_EQ(opened.warnings,
              std::vector<std::string>{
                  "points.csv: found 1 of 3 sources off the terrain; left out, expected sources on the "
                  "terrain"});
}

TEST(SourceShapes, OfPolygonsBecomeCells) {
    const SampleProject project;
    project.write("areas.csv",
                  "zone,wkt\n3,\"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 2030))\"\n");
    const Opened shapes = open(project, {"release.source=", "release.source_shapes=areas.csv"});
    const Opened grid = open(project);
    ASSERT_TRUE(shapes.site) << shapes.errors;
    ASSERT_EQ(shapes.site->sources.size(), grid.site->sources.size());
    for (std::size_t i = 0; i < grid.site->sources.size(); ++i) {
        EXPECT_EQ(shapes.site->sources[i].first_m, grid.site->sources[i].first_m);
        EXPECT_EQ(shapes.site->sources[i].zone, 3U);
    }
}

TEST(SourceShapes, OfDifferentKindsAreRefused) {
    const SampleProject project;
    project.write("mixed.csv", "wkt\nPOINT (1020 2050)\n\"LINESTRING (1020 2030, 1020 2060)\"\n");
    const Opened opened = open(project, {"release.source=", "release.source_shapes=mixed.csv"});
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_NE(opened.errors.find("mixed.csv:3:1: found another kind of shape than above"), std::string::npos)
        << opened.errors;
}

}  // namespace
}  // namespace coupling
