#include "coupling/inputs/release/release_input.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::release_input_test {
namespace {

std::string source_grid(int column, int first_row, int last_row) {
    return SampleProject::header() + SampleProject::rows([=](int c, int r) {
               return c == column && r >= first_row && r <= last_row ? "1" : "0";
           });
}

TEST(SourceGrid, WeighsCellsByTheirTrueSurface) {
    const SampleProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 4U);
    // The slope rises 7 m in 10 m: 100 m2 in plan are 100 * sqrt(1 + 0.7^2) m2 of ground.
    EXPECT_NEAR(opened.site->sources[0].weight, 100.0 * std::sqrt(1.49), 1e-4);
    EXPECT_EQ(opened.site->rocks(), 20U);
    EXPECT_EQ(open(project, {"release.rocks=33"}).site->rocks(), 33U);
}

TEST(SourceGrid, InTheOuterRingIsLeftOut) {
    const SampleProject project;
    project.write("source.asc", source_grid(2, 0, 4));
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->sources.size(), 4U);
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

TEST(SourceShapes, SmallerThanACellReleaseTheirRocksInside) {
    const SampleProject project;
    project.write("areas.csv",
                  "zone,wkt\n3,\"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 2030))\"\n"
                  "4,\"POLYGON ((1041 2031, 1043 2031, 1043 2033, 1041 2033, 1041 2031))\"\n");
    const Opened opened = open(project, {"release.source=", "release.source_shapes=areas.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.warnings, std::vector<std::string>{
                                   "areas.csv: 1 source polygon of 2 between the centres of the cells: rocks "
                                   "start at random inside"});
    ASSERT_EQ(opened.site->sources.size(), 5U);
    const rockfall::ReleaseSource& small = opened.site->sources.back();
    EXPECT_EQ(small.zone, 4U);
    ASSERT_TRUE(small.outline);
    // 4 m2 in plan on a slope of 0.7.
    EXPECT_NEAR(small.weight, 4.0 * std::sqrt(1.0 + 0.49), 1e-6);
}

TEST(SourceShapes, OfManySmallOutcropsAreOneNote) {
    const SampleProject project;
    std::string text = "wkt\n";
    for (int i = 0; i < 50; ++i) {
        const std::string x = std::to_string(1021 + i % 10) + ".2 ", y = std::to_string(2031 + i / 10) + ".2";
        const std::string east = std::to_string(1021 + i % 10) + ".8 ",
                          north = std::to_string(2031 + i / 10) + ".8";
        text += "\"POLYGON ((" + x + y + ", " + east + y + ", " + east + north + ", " + x + north + ", " + x +
                y + "))\"\n";
    }
    project.write("areas.csv", text);
    const Opened opened = open(project, {"release.source=", "release.source_shapes=areas.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->sources.size(), 50U);
    EXPECT_EQ(opened.warnings.size(), 1U);
}

TEST(SourceShapes, ThatStandTwiceReleaseOnce) {
    const SampleProject project;
    const std::string area = "\"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 2030))\"\n";
    project.write("areas.csv", "zone,wkt\n3," + area + "3," + area);
    const Opened opened = open(project, {"release.source=", "release.source_shapes=areas.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->sources.size(), 4U);
}

TEST(SourceShapes, SmallAndTwiceReleaseOnce) {
    const SampleProject project;
    const std::string area = "\"POLYGON ((1041 2031, 1043 2031, 1043 2033, 1041 2033, 1041 2031))\"\n";
    project.write("areas.csv", "zone,wkt\n3," + area + "4," + area);
    const Opened opened = open(project, {"release.source=", "release.source_shapes=areas.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->sources.size(), 1U);
    EXPECT_EQ(opened.site->sources[0].zone, 4U);
    EXPECT_NE(opened.warnings[0].find("stands a second time in row 3"), std::string::npos);
}

TEST(SourceShapes, AreTakenFromXAndY) {
    const SampleProject project;
    project.write("points.csv", "rock_id,x_m,y_m,mass_t,speed_mps\n1,1025,2035,0.4,1\n2,1025,2045,1.2,1\n");
    const Opened opened = open(project, {"release.source=", "release.source_shapes=points.csv"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->sources.size(), 2U);
    EXPECT_EQ(opened.warnings, std::vector<std::string>{"points.csv: columns that are not read: 'rock_id'"});
}

/// A project whose rocks come from shapes.
Opened open_shapes(const std::string& table, std::vector<std::string> overrides = {}) {
    const SampleProject project;
    project.write("cliffs.csv", table);
    overrides.insert(overrides.end(), {"release.source=", "release.source_shapes=cliffs.csv"});
    return open(project, overrides);
}

/// The same with one line of these columns beside its WKT.
Opened open_line(const std::string& columns, const std::string& fields,
                 const std::vector<std::string>& overrides = {}) {
    return open_shapes("wkt," + columns + "\n\"LINESTRING (1020 2030, 1020 2060)\"," + fields + "\n",
                       overrides);
}

TEST(SourceStart, IsThatOfTheScenarioWhereTheRowSaysNothing) {
    const Opened opened = open_line("blocks,speed_mps,mass_t", ",,");
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->sources[0].own_start, nullptr);
    EXPECT_EQ(opened.site->sources[0].rocks, 5U);
    EXPECT_FALSE(opened.site->sources[0].evenly);
}

TEST(SourceStart, GivesALineItsBlocksAndSharesOutTheRest) {
    const Opened opened = open_shapes(
        "wkt,blocks\n\"LINESTRING (1020 2030, 1020 2050, 1020 2060)\",30\n"
        "\"LINESTRING (1030 2030, 1030 2040)\",\n",
        {"release.rocks=7"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const auto& sources = opened.site->sources;
    ASSERT_EQ(sources.size(), 3U);
    EXPECT_EQ(sources[0].rocks, 20U);
    EXPECT_EQ(sources[1].rocks, 10U);
    EXPECT_EQ(sources[2].rocks, 7U);
    EXPECT_EQ(sources[2].first_rock, 30U);
    EXPECT_TRUE(sources[0].evenly);
    EXPECT_FALSE(sources[2].evenly);
}

TEST(SourceStart, GivesPointsAndCellsTheirBlocks) {
    const Opened points = open_shapes("wkt,blocks\nPOINT (1020 2050),3\nPOINT (1030 2050),400\n");
    ASSERT_TRUE(points.site) << points.errors;
    EXPECT_EQ(points.site->sources[0].rocks, 3U);
    EXPECT_EQ(points.site->sources[1].rocks, 400U);

    const Opened cells = open_shapes(
        "zone,wkt,blocks,diameter_m\n3,\"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 "
        "2030))\",9,1.5\n");
    ASSERT_TRUE(cells.site) << cells.errors;
    EXPECT_EQ(cells.site->rocks(), 9U);
    for (const rockfall::ReleaseSource& cell : cells.site->sources) {
        EXPECT_EQ(cell.zone, 3U);
        ASSERT_TRUE(cell.own_start);
        EXPECT_EQ(cell.own_start->diameter.mean_m(), 1.5);
    }
}

TEST(SourceStart, TakesSpeedAndAzimuth) {
    const Opened opened = open_line("speed_mps,azimuth_deg", "6,80");
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::StartLaw& law = *opened.site->sources[0].own_start;
    EXPECT_EQ(law.speed_mps, 6.0);
    EXPECT_EQ(law.height_m, 1.5);
    ASSERT_TRUE(law.azimuth);
    EXPECT_DOUBLE_EQ(law.azimuth->in_degrees(), 80.0);
    EXPECT_EQ(law.diameter.mean_m(), 0.5);  // of the scenario
}

TEST(SourceStart, AnAzimuthAloneTurnsTheSpeedOfAllRocks) {
    const Opened opened = open_line("azimuth_deg", "80", {"release.start_speed_mps=2"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const rockfall::StartLaw& law = *opened.site->sources[0].own_start;
    EXPECT_EQ(law.speed_mps, 2.0);
    EXPECT_DOUBLE_EQ(law.azimuth->in_degrees(), 80.0);
}

TEST(SourceStart, TakesAFallHeightInsteadOfASpeed) {
    const Opened opened = open_line("fall_height_m", "12");
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->sources[0].own_start->height_m, 12.0);
    EXPECT_EQ(opened.site->sources[0].own_start->speed_mps, 0.0);

    const Opened speed = open_line("speed_mps", "2", {"release.fall_height_m=30"});
    ASSERT_TRUE(speed.site) << speed.errors;
    EXPECT_EQ(speed.site->sources[0].own_start->height_m, 1.5);
    EXPECT_EQ(speed.site->sources[0].own_start->speed_mps, 2.0);
}

TEST(SourceStart, TakesSizeAsDiameterMassOrVolume) {
    const double one_cubic_metre_m = std::cbrt(6.0 / M_PI);
    for (const auto& [columns, fields, diameter_m] :
         {std::tuple{"diameter_m", "0.8", 0.8}, std::tuple{"volume_m3", "1", one_cubic_metre_m},
          std::tuple{"mass_t,density_kgpm3", "2.5,2500", one_cubic_metre_m},
          std::tuple{"mass_t", "2.7", one_cubic_metre_m}}) {
        const Opened opened = open_line(columns, fields);
        ASSERT_TRUE(opened.site) << opened.errors;
        const rockfall::StartLaw& law = *opened.site->sources[0].own_start;
        EXPECT_NEAR(law.diameter.mean_m(), diameter_m, 1e-12) << columns;
    }
    EXPECT_EQ(open_line("density_kgpm3", "2500").site->sources[0].own_start->density_kgpm3, 2500.0);
}

TEST(SourceStart, GoesBeforeTheNumberOfRocksOfTheScenario) {
    const Opened opened = open_line("blocks", "3", {"release.rocks=50"});
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.site->rocks(), 3U);
}

}  // namespace
}  // namespace coupling::release_input_test
