#include "coupling/inputs/nets/net_input.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "coupling/inputs/nets/net_classes.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::net_input_test {
namespace {

using config::ExitCode;

constexpr const char* header = "name,height_m,capacity_kj,class,gap_m,wkt\n";

Opened open_with(const std::string& rows) {
    const SampleProject project;
    project.write("nets.csv", header + rows);
    project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
    return open(project);
}

std::string errors_of(const std::string& rows) {
    const Opened opened = open_with(rows);
    EXPECT_FALSE(opened.site);
    EXPECT_EQ(opened.code, ExitCode::data);
    return opened.errors;
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

TEST(Nets, WhollyOrPartlyOffTheTerrainAreRefused) {
    EXPECT_EQ(
        errors_of("a,3,500,,,\"LINESTRING (1090 2010, 1090 2190)\"\n"),
        "nets.csv:2:11: found net 'a' leaves the terrain at x 1090, y 2096, expected a line wholly on the "
        "terrain; shorten the net, or take a larger terrain");
    const std::string elsewhere = errors_of("a,3,500,,,\"LINESTRING (5090 2010, 5090 2090)\"\n");
    EXPECT_NE(elsewhere.find("net 'a' outside the terrain: "), std::string::npos) << elsewhere;
    EXPECT_NE(elsewhere.find("; the net spans 5 090 to 5 090 east"), std::string::npos) << elsewhere;
}

TEST(Nets, WithSwappedAxesAreRefusedWithTheCauseAndWhatToDo) {
    const std::string swapped = errors_of("a,3,500,,,\"LINESTRING (2010 1090, 2090 1090)\"\n");
    EXPECT_NE(swapped.find("net 'a' outside the terrain: x and y look swapped; "), std::string::npos)
        << swapped;
    EXPECT_TRUE(swapped.ends_with("; exchange x and y in the lines")) << swapped;
}

TEST(Nets, InOnePlaceAreRefusedWithBothNamesAndLines) {
    const std::string a = "a,3,500,,,\"LINESTRING (1090 2010, 1090 2090)\"\n";
    EXPECT_EQ(errors_of(a + "b,5,900,,,\"LINESTRING (1090 2090, 1090 2010)\"\n"),
              "nets.csv:3:11: found net 'b' in the place of net 'a' of line 2 over 80 m, expected nets apart "
              "from each other: where two stand in one place, rocks that break the first would miss the "
              "second");
    EXPECT_NE(errors_of(a + "b,5,900,,,\"LINESTRING (1080 2040, 1090 2050, 1090 2050.5, 1080 2060)\"\n")
                  .find("over 0.53 m"),
              std::string::npos)
        << "half a metre, and 14 mm of each piece that runs into it";
}

TEST(Nets, MayCrossTouchAndFollowEachOther) {
    const Opened opened = open_with(
        "a,3,500,,,\"LINESTRING (1090 2010, 1090 2050)\"\n"
        "end to end,3,500,,,\"LINESTRING (1090 2050, 1090 2090)\"\n"
        "across,3,500,,,\"LINESTRING (1080 2030, 1100 2034)\"\n"
        "behind,3,500,,,\"LINESTRING (1090.1 2010, 1090.1 2050)\"\n");
    EXPECT_TRUE(opened.site) << opened.errors;
    EXPECT_TRUE(opened.warnings.empty()) << opened.warnings.front();
}

TEST(Nets, ThatLookLikeASlipAreDoubted) {
    const SampleProject project;
    project.write("nets.csv",
                  "name,height_m,capacity_kj,gap,wkt\n"
                  "A net,0.3,500,0.2,\"LINESTRING (1090 2010, 1090 2050)\"\n"
                  "a Net,3,5,0.2,\"LINESTRING (1094 2010, 1094 2050)\"\n");
    project.replace("scenario.ini", "[targets]", "[nets]\nfile = nets.csv\n[targets]");
    const Opened opened = open(project);
    ASSERT_TRUE(opened.site) << opened.errors;
    ASSERT_EQ(opened.warnings.size(), 4U);
    EXPECT_EQ(opened.warnings[0],
              "nets.csv: found column 'gap', which is passed over, expected gap_m, if that is what is meant");
    EXPECT_EQ(opened.warnings[1],
              "nets.csv:2:7: found a net of 0.3 m, expected a height in metres: nets are 1.5 to "
              "10 m high; check the unit of the column height_m");
    EXPECT_EQ(opened.warnings[2],
              "nets.csv:3:9: found a net that takes 5 kJ, expected kilojoules: the weakest "
              "nets on offer take 35 kJ; multiply megajoules by 1000");
    EXPECT_EQ(opened.warnings[3],
              "nets.csv:3:1: found name 'a Net' beside 'A net', expected names that differ by more than "
              "capitals and blanks");
}

struct Bad {
    std::string rows;
    std::string message;
};

TEST(Nets, ThatCannotStandAreRefusedWithTheirPlace) {
    const std::string line = ",\"LINESTRING (1090 2010, 1090 2090)\"\n";
    for (const Bad& bad : {
             Bad{"a,3,500,,3" + line,
                 "nets.csv:2:10: found a gap of 3 m below a net up to 3 m, expected gap_m below height_m"},
             Bad{"a,3,,,0" + line, "nets.csv:2:5: found neither capacity_kj nor class, expected one of them"},
             Bad{"a,3,500,5,0" + line,
                 "nets.csv:2:5: found both capacity_kj and class, expected one of them"},
             Bad{"a,3,,9,0" + line,
                 "nets.csv:2:6: found class '9', expected a class of `bannwald info net_classes`: 0 to 7"},
             Bad{"a,3,,8,0" + line,
                 "nets.csv:2:6: found class '8', which has no upper limit, expected capacity_kj of the net "
                 "instead"},
             Bad{"a,3,500,,0,\"LINESTRING (1090 2010, 1090 2010)\"\n", "a net of length 0 m"},
             Bad{"a,3,500,,0,\"LINESTRING (1080 2010, 1080 2050, 1090 2040, 1070 2040)\"\n",
                 "net 'a' crosses or touches itself"},
             Bad{"a,3,500,,0,\"LINESTRING (1080 2010, 1080 2050, 1080 2020)\"\n",
                 "net 'a' crosses or touches itself"},
             Bad{"a,3,500,,0,POINT (1080 2010)\n", "expected lines"},
             Bad{"a,3,500,,0,\"MULTILINESTRING ((1 2, 3 4), (5 6, 7 8))\"\n",
                 "found 2 lines, expected one line in each row"},
         }) {
        EXPECT_NE(errors_of(bad.rows).find(bad.message), std::string::npos)
            << bad.rows << errors_of(bad.rows);
    }
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
