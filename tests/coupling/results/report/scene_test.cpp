#include "coupling/results/report/scene.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/coupling/parts_of_text.hpp"
#include "tests/coupling/results/markup_checks.hpp"

namespace coupling::report::scene_test {
namespace {

using text_checks::has;

config::Raster<double> some_ground() {
    config::GridFrame frame;
    frame.columns = 600;
    frame.rows = 2;
    frame.cell_width_m = frame.cell_height_m = 10.0;
    frame.x_west_m = 1000.0;
    frame.y_south_m = 2000.0;
    config::Raster<double> heights{frame, 500.0};
    heights.at({599, 0}) = std::numeric_limits<double>::quiet_NaN();
    return heights;
}

TEST(SceneFigure, ThinsTheGroundAndCountsFromItsSouthWesternCorner) {
    const config::Raster<double> heights = some_ground();
    Scene scene{.heights = heights};
    scene.species = {{"<spruce>", "#117733", true}};
    scene.stands = {{"", 0, {{.x_m = 1000.0, .y_m = 2000.0, .dbh_cm = 30.0, .height_m = 10.0}}}};
    const std::string figure = scene_figure(scene, "Nothing <b>here</b>.");
    EXPECT_EQ(text_checks::markup_fault(figure), "");
    EXPECT_FALSE(has(figure, "<spruce>"));
    EXPECT_TRUE(has(figure, "Nothing <b>here</b>."));
    EXPECT_TRUE(has(figure, "\"columns\":200,\"rows\":1,\"block\":3")) << "at most 256 a side";
    EXPECT_TRUE(has(figure, "\"low_m\":500"));
    // Two bytes, lower one first: 0, 300 mm, 1000 cm.
    EXPECT_TRUE(has(figure, "\"x\":\"AAA=\",\"y\":\"AAA=\",\"dbh_mm\":\"LAE=\",\"height_cm\":\"6AM=\""));
    EXPECT_TRUE(has(figure, "\"trees\":1,\"left_out\":0"));
}

TEST(SceneFigure, WritesLyingStemsAndPathsOfAYear) {
    const config::Raster<double> heights = some_ground();
    const config::GridFrame& frame = heights.frame;
    Scene scene{.heights = heights};
    const double x_m = frame.x_west_m;
    const double y_m = frame.y_south_m;
    SceneStand stand;
    stand.logs = {{.x_m = x_m, .y_m = y_m, .length_m = 0.0, .direction_rad = 0.0}};
    stand.paths = {{{{x_m, y_m, 0.0}, 400'000.0F, 0.0F}, {{x_m, y_m, 0.0}, 10'000.0F, 0.0F}}};
    scene.stands = {stand};
    const std::string figure = scene_figure(scene, "");
    // Both ends of the log in the corner: four numbers 0.
    EXPECT_TRUE(has(figure, "\"logs\":\"AAAAAAAAAAA=\""));
    // Energy classes 3 (above 300 kJ) and 0.
    EXPECT_TRUE(has(figure, "\"classes\":\"AwA=\",\"cover\":\"forest\"")) << figure;
}

TEST(SceneFigure, SharesLogsAndPathsAmongStandsAndTellsHowManyThereAre) {
    const config::Raster<double> heights = some_ground();
    const config::GridFrame& frame = heights.frame;
    const rockfall::PathPoint corner{{frame.x_west_m, frame.y_south_m, 0.0}, 1000.0F, 0.0F};
    SceneStand stand;
    stand.logs.assign(60'000, {frame.x_west_m, frame.y_south_m, 1.0, 0.0});
    stand.paths.assign(200, ScenePath(500, corner));
    Scene alone{.heights = heights};
    alone.stands = {stand};
    EXPECT_TRUE(has(scene_figure(alone, ""), "\"drawn_logs\":60000,\"all_logs\":60000,\"all_paths\":200"));
    Scene two{.heights = heights};
    two.stands = {stand, stand};
    const std::string figure = scene_figure(two, "");
    EXPECT_TRUE(has(figure, "\"drawn_logs\":30000,\"all_logs\":60000,\"all_paths\":200"));
    std::size_t paths = 0;
    for (std::size_t at = figure.find("\"points\""); at != std::string::npos;
         at = figure.find("\"points\"", at + 1)) {
        ++paths;
    }
    EXPECT_EQ(paths, 2U * 100U) << "50 000 corners a stand";
}

TEST(SceneFigure, WritesTreesOfACommonStartOnce) {
    const config::Raster<double> heights = some_ground();
    Scene scene{.heights = heights};
    scene.species = {{"spruce", "#117733", true}};
    scene.stands = {{"A", 0, {{.x_m = 1010.0, .y_m = 2010.0, .dbh_cm = 30.0, .height_m = 10.0}}},
                    {.regime = "B", .year = 0, .trees = {}, .same_as = 0}};
    const std::string figure = scene_figure(scene, "");
    EXPECT_TRUE(has(figure, "{\"regime\":\"B\",\"year\":0,\"same_as\":0}"));
}

}  // namespace
}  // namespace coupling::report::scene_test
