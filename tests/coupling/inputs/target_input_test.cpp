#include "coupling/inputs/target_input.hpp"

#include <gtest/gtest.h>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::target_input_test {
namespace {

using config::ExitCode;

TEST(Targets, OfPointsOrBrokenTextAreRefused) {
    const SampleProject project;
    project.write("targets.csv", "target_id,name,wkt\na,x,POINT (1050 2050)\na,y,LINESTRING (1 2\n");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_NE(opened.errors.find("targets.csv:2:5: found 'POINT (1050 2050)', expected lines or polygons"),
              std::string::npos)
        << opened.errors;
    EXPECT_NE(opened.errors.find("targets.csv:3:"), std::string::npos) << opened.errors;
}

TEST(Targets, WithTheSameNameTwiceAreRefused) {
    const SampleProject project;
    project.write(
        "targets.csv",
        "target_id,wkt\na,\"LINESTRING (1105 2010, 1105 2090)\"\na,\"LINESTRING (1095 2010, 1095 2090)\"\n");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, ExitCode::data);
    EXPECT_EQ(opened.errors,
              "targets.csv:3:1: found target_id 'a' a second time, expected one target_id for each target");
}

TEST(Targets, OffTheTerrainAreDoubted) {
    const SampleProject project;
    project.replace("targets.csv", "1105 2090", "1105 2190");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.warnings,
              std::vector<std::string>{
                  "targets.csv: found target 'road' with 1 of 2 vertices off the terrain, expected "
                  "targets where rocks can be followed to"});
}

TEST(Targets, WhollyOffTheTerrainAreRefused) {
    const SampleProject project;
    project.write("targets.csv", "target_id,name,wkt\nroad,road,\"LINESTRING (91010 2010, 91090 2010)\"\n");
    const Opened opened = open(project);
    EXPECT_FALSE(opened.site);
    EXPECT_EQ(
        opened.errors,
        "targets.csv: found target 'road' with no vertex on the terrain, expected coordinates of the DEM: "
        "no rock can arrive there");
}

}  // namespace
}  // namespace coupling::target_input_test
