#include "coupling/inputs/site.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::site_test {
namespace {

TEST(Site, HoldsWhatTheFilesSay) {
    const SampleProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.warnings, std::vector<std::string>{});
    const Site& site = *opened.site;
    EXPECT_EQ(site.slope.terrain.vertices().size(), 120U);
    EXPECT_EQ(site.slope.types.size(), 2U);
    EXPECT_EQ(site.trees.size(), 3U);
    EXPECT_EQ(site.trees[1].species, "PIAB");
    EXPECT_EQ(site.trees[2].species, "FASY");
    EXPECT_EQ(site.targets.size(), 2U);
    EXPECT_TRUE(site.targets[1].is_area);
    EXPECT_EQ(site.projection, "PROJCS[\"Sample\"]\n");
    EXPECT_EQ(site.inputs.size(), 7U);
    EXPECT_EQ(site.map_frame.columns, 12);
}

TEST(Site, LaysEverythingOnOneTerrain) {
    const SampleProject project;
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    const Site& site = *opened.site;
    const auto at = [&](double x_m, double y_m) -> Eigen::Vector2d {
        return Eigen::Vector2d{x_m, y_m} - site.origin_m();
    };
    const Eigen::Vector2d on_rock = at(1020.0, 2050.0);
    const Eigen::Vector2d on_soil = at(1080.0, 2050.0);
    EXPECT_EQ(site.slope.type_at(on_rock.x(), on_rock.y()).label, "rock");
    EXPECT_EQ(site.slope.type_at(on_soil.x(), on_soil.y()).label, "soil");
    // The plane of the slope: 400 m at the centre of the first column, 7 m less with each column.
    EXPECT_NEAR(site.slope.terrain.height_m(on_soil.x(), on_soil.y()).value_or(0.0), 400.0 - 0.7 * 75.0,
                1e-9);
    EXPECT_EQ(site.sources[0].first_m, at(1020.0, 2060.0));
    EXPECT_EQ(site.sources[0].last_m, at(1030.0, 2070.0));
    EXPECT_EQ(site.targets[0].parts[0][0], at(1105.0, 2010.0));
    EXPECT_DOUBLE_EQ(site.map_frame_on_terrain().x_west_m, 1000.0 - site.origin_m().x());
}

TEST(Site, MapsMayHaveCellsOfTheirOwn) {
    const SampleProject project;
    const Opened opened = open(project, {"output.cell_size_m=4"});
    ASSERT_TRUE(opened.site) << opened.errors;
    const Site& site = *opened.site;
    EXPECT_EQ(site.map_frame.columns, 30);
    EXPECT_EQ(site.map_frame.rows, 25);
    EXPECT_DOUBLE_EQ(site.map_frame.x_west_m, 1000.0);
    const config::Cell cell = site.map_frame.cell_at(1050.0, 2050.0);
    EXPECT_NEAR(site.heights.at(cell), 400.0 - 0.7 * (site.map_frame.x_centre_m(cell.column) - 1005.0), 1e-9);
    EXPECT_EQ(site.slope.types[site.surface.at(cell)].label, "soil");
}

TEST(Site, KnowsItsInputsByTheirBytes) {
    const SampleProject project;
    const std::string before = open(project).site->inputs.front().hash;
    EXPECT_EQ(open(project).site->inputs.front().hash, before);
    project.replace("dem.asc", "400", "401");
    EXPECT_NE(open(project).site->inputs.front().hash, before);
}

}  // namespace
}  // namespace coupling::site_test
