#include "coupling/inputs/places/target_input.hpp"

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

TEST(Targets, OffTheTerrainAreDoubted) {
    const SampleProject project;
    project.replace("targets.csv", "1105 2090", "1105 2190");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(
        opened.warnings,
        std::vector<std::string>{
            "targets.csv: found target 'road' with 53 % of its length off the terrain, expected targets "
            "where rocks can be followed to; take a larger terrain if that part matters: no rock is "
            "counted there"});
}

TEST(Targets, WhollyOffTheTerrainAreRefused) {
    const SampleProject project;
    project.write("targets.csv", "target_id,name,wkt\nroad,road,\"LINESTRING (91010 2010, 91090 2010)\"\n");
    const Opened opened = open(project);
    EXPECT_FALSE(opened.site);
    EXPECT_EQ(
        opened.errors,
        "targets.csv: found target 'road' outside the terrain: perhaps another coordinate system or another "
        "place; the target spans 91 010 to 91 090 east, 2 010 to 2 010 north, the terrain 1 005 to 1 115 "
        "east, 2 005 to 2 095 north, expected targets on the terrain: no rock can arrive elsewhere; "
        "compare the coordinate system of both files, then transform one of them");
}

TEST(Targets, ThatOnlyCrossTheTerrainAreKept) {
    const SampleProject project;
    project.write("targets.csv", "target_id,wkt\nroad,\"LINESTRING (1105 1900, 1105 2200)\"\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.warnings.size(), 1U);
    EXPECT_NE(opened.warnings[0].find("70 % of its length off the terrain"), std::string::npos)
        << opened.warnings[0];
}

}  // namespace
}  // namespace coupling::target_input_test
