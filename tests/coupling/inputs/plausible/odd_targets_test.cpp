#include "coupling/inputs/plausible/odd_targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/coupling/inputs/opened.hpp"
#include "tests/coupling/inputs/plausible/turned.hpp"

namespace coupling::plausible::odd_targets_test {
namespace {

TEST(CrossesItself, IsTrueOfABowTieHoweverItIsTurned) {
    const std::vector<Eigen::Vector2d> bow{{0, 0}, {10, 10}, {10, 0}, {0, 10}, {0, 0}};
    const std::vector<Eigen::Vector2d> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}};
    const std::vector<Eigen::Vector2d> bay{{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 2},
                                           {4, 2}, {4, 10}, {0, 10},  {0, 0}};
    for (const Turn& turn : all_turns()) {
        const auto turned = [&](std::vector<Eigen::Vector2d> ring) {
            for (Eigen::Vector2d& corner : ring) {
                corner = turn.of(corner);
            }
            return ring;
        };
        EXPECT_TRUE(crosses_itself(turned(bow)));
        EXPECT_FALSE(crosses_itself(turned(square)));
        EXPECT_FALSE(crosses_itself(turned(bay)));
    }
}

TEST(OddTargets, WithoutLengthOrAreaAreRefused) {
    const SampleProject project;
    project.write(
        "targets.csv",
        "target_id,wkt\nroad,\"LINESTRING (1105 2050, 1105 2050)\"\nhouse,\"POLYGON ((1090 2040, 1100 "
        "2040, 1095 2040, 1090 2040))\"\n");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, config::ExitCode::data);
    EXPECT_NE(opened.errors.find("found target 'road' without length"), std::string::npos) << opened.errors;
    EXPECT_NE(opened.errors.find("found target 'house' without area"), std::string::npos) << opened.errors;
}

TEST(OddTargets, ThatCrossThemselvesAreWarnedOf) {
    const SampleProject project;
    project.replace("targets.csv", "1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040",
                    "1090 2040, 1100 2050, 1100 2040, 1090 2050, 1090 2040");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.warnings.size(), 1U);
    EXPECT_NE(opened.warnings.front().find("target 'house' with an outline that crosses itself"),
              std::string::npos)
        << opened.warnings.front();
}

TEST(OddTargets, OfOneShapeAreNoted) {
    const SampleProject project;
    project.write(
        "targets.csv",
        "target_id,wkt\na,\"LINESTRING (1105 2010, 1105 2090)\"\nb,\"LINESTRING (1105 2090, 1105 2010)\"\n");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    EXPECT_EQ(opened.warnings,
              std::vector<std::string>{
                  "targets.csv: targets 'a' and 'b' have the same shape and count the same rocks"});
}

}  // namespace
}  // namespace coupling::plausible::odd_targets_test
