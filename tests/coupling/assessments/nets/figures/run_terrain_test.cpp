#include "coupling/assessments/nets/figures/run_terrain.hpp"

#include <gtest/gtest.h>

#include "config/geometry/wkt.hpp"
#include "coupling/inputs/formats/system_text.hpp"
#include "tests/coupling/inputs/sample_project.hpp"
#include "tests/rockfall/slopes.hpp"

namespace coupling::run_terrain_test {
namespace {

constexpr const char* road_in_degrees =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"name":"road"},)"
    R"("geometry":{"type":"LineString","coordinates":[[11.40,47.20],[11.41,47.20]]}}]})";

config::Point2 first_point(const TableOnRun& of) {
    return config::read_wkt(of.table.text(0, "wkt"), {}).parts.front().front();
}

// GeoJSON is in degrees (RFC 7946). Expected coordinates are those of gdaltransform (GDAL 3.6, PROJ 9.1).
TEST(TableOnRun, BringsALayerIntoTheSystemOfTheRun) {
    const SampleProject project;
    project.write("road.geojson", road_in_degrees);
    const rockfall::Slope slope = rockfall::testing::plane_slope(30.0, {0.3, 0.8});
    std::vector<std::string> remarks;
    const TableOnRun moved = table_on({slope.terrain, formats::esri_text_of("EPSG:31254")},
                                      project.file("road.geojson"), "a layer", remarks);
    EXPECT_NEAR(first_point(moved).x_m, 80'846.7308, 0.05);
    EXPECT_NEAR(first_point(moved).y_m, 229'561.7388, 0.05);
    EXPECT_TRUE(moved.has_own_shapes);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("road.geojson: transformed from "), std::string::npos) << remarks[0];
}

TEST(TableOnRun, LeavesCoordinatesWhereTheRunHasNoSystemOrTheSame) {
    const SampleProject project;
    project.write("road.geojson", road_in_degrees);
    const rockfall::Slope slope = rockfall::testing::plane_slope(30.0, {0.3, 0.8});
    for (const std::string& system : {std::string{}, formats::esri_text_of("EPSG:4326")}) {
        std::vector<std::string> remarks;
        const TableOnRun same =
            table_on({slope.terrain, system}, project.file("road.geojson"), "a layer", remarks);
        EXPECT_EQ(first_point(same).x_m, 11.40) << system;
        EXPECT_TRUE(remarks.empty()) << system;
    }
}

}  // namespace
}  // namespace coupling::run_terrain_test
