#include "coupling/inputs/nets/net_input.hpp"

#include <gtest/gtest.h>

#include "coupling/inputs/nets/net_classes.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::net_input_test {
namespace {

constexpr const char* header = "name,height_m,capacity_kj,class,gap_m,wkt\n";

Opened open_with(const std::string& rows) {
    const SampleProject project;
    project.write("nets.csv", header + rows);
    project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
    return open(project);
}

TEST(Nets, StandInCoordinatesOfTheTerrain) {
    const Opened opened = open_with(
        "upper,3,500,,0.2,\"LINESTRING (1090 2010, 1090 2050, 1090 2050, 1092 2090)\"\n"
        "lower,4,,5,,\"LINESTRING (1100 2010, 1100 2090)\"\n");
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.site->nets.size(), 2U);
    const NetRecord& upper = opened.site->nets[0];
    EXPECT_EQ(upper.name, "upper");
    EXPECT_EQ(upper.net.line_m.size(), 3U);  // a corner given twice is one corner
    EXPECT_DOUBLE_EQ(upper.net.line_m[0].x() + opened.site->origin_m().x(), 1090.0);
    EXPECT_DOUBLE_EQ(upper.net.capacity_j, 500e3);
    EXPECT_DOUBLE_EQ(upper.net.gap_m, 0.2);
    EXPECT_EQ(opened.site->nets[1].energy_class, "5");
    EXPECT_DOUBLE_EQ(opened.site->nets[1].net.capacity_j, 2000e3);
    EXPECT_DOUBLE_EQ(opened.site->nets[1].net.gap_m, 0.0);
}

TEST(Nets, MayCrossTouchAndFollowEachOther) {
    const Opened opened = open_with(
        "a,3,500,,,\"LINESTRING (1090 2010, 1090 2025)\"\n"
        "end to end,3,500,,,\"LINESTRING (1090 2025, 1090 2036)\"\n"
        "across,3,500,,,\"LINESTRING (1080 2018, 1100 2022)\"\n"
        "behind,3,500,,,\"LINESTRING (1090.1 2010, 1090.1 2025)\"\n");
    EXPECT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(opened.warnings.empty()) << opened.warnings.front();
}

TEST(Nets, MayCloseAroundAPlace) {
    const Opened opened =
        open_with("ring,3,500,,,\"LINESTRING (1080 2040, 1090 2040, 1090 2050, 1080 2050, 1080 2040)\"\n");
    EXPECT_TRUE(opened.site) << opened.errors;
}

TEST(NetClasses, GrowAndEndOpen) {
    const auto& classes = net_classes();
    for (std::size_t i = 1; i < classes.size(); ++i) {
        EXPECT_LT(classes[i - 1].mel_kj, classes[i].mel_kj);
    }
    EXPECT_TRUE(std::isinf(classes.back().mel_kj));
    EXPECT_EQ(class_for(100.0).name, "0");
    EXPECT_EQ(class_for(1000.1).name, "4");
    EXPECT_EQ(class_for(1e5).name, classes.back().name);
}

}  // namespace
}  // namespace coupling::net_input_test
