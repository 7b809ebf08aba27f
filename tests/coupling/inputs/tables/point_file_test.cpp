#include "coupling/inputs/tables/point_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"

namespace coupling::point_file_test {
namespace {

using tables::PointFile;
using tables::read_point_file;

const std::vector<Eigen::Vector3d> wanted{{0.25, 0.75, 300.0}, {0.25, 5.25, 304.0}, {4.5, 5.25, 307.5}};

std::string number(double value, char mark) {
    std::string text = std::to_string(value);
    std::replace(text.begin(), text.end(), '.', mark);
    return text;
}

TEST(PointFile, ReadsFieldsInQuotesWithSeparatorsInside) {
    const PointFile read =
        read_point_file("\"rebar_id\",\"x\",\"y\",\"elev\"\n\"1,1\",0,20,\"293.5\"\n\"1,2\",0,40,292\n", "f");
    ASSERT_EQ(read.points.size(), 2U);
    EXPECT_EQ(read.points[0], (Eigen::Vector3d{0.0, 20.0, 293.5}));
}

TEST(PointFile, RefusesACoordinateThatStandsTwice) {
    EXPECT_THROW(read_point_file("x,y,z,x\n1,2,3,4\n", "f"), config::InputError);
    EXPECT_EQ(read_point_file("x,y,z,id,id\n1,2,3,4,5\n", "f").points.size(), 1U);
}

TEST(PointFile, GivesTheSamePointsInAnyOrderAndForm) {
    struct Column {
        const char* name;
        int coordinate;  // 3: none
    };
    const std::array<std::array<const char*, 3>, 4> names{{{"x", "y", "z"},
                                                           {"Easting", "Northing", "Elevation"},
                                                           {"X [m]", "Y [m]", "Z [m]"},
                                                           {"Rechtswert", "Hochwert", "Höhe"}}};
    std::mt19937 random{13};
    for (int trial = 0; trial < 200; ++trial) {
        const auto& called = names[random() % names.size()];
        std::vector<Column> columns{
            {called[0], 0}, {called[1], 1}, {called[2], 2}, {"id", 3}, {"intensity", 3}};
        std::shuffle(columns.begin(), columns.end(), random);
        const char separator = ";\t,"[random() % 3];
        const char mark = separator != ',' && random() % 2 == 0 ? ',' : '.';
        std::string text = trial % 2 == 0 ? "" : "\xEF\xBB\xBF";
        for (std::size_t i = 0; i < columns.size(); ++i) {
            text += (i == 0 ? "" : std::string(1, separator)) + columns[i].name;
        }
        for (std::size_t point = 0; point < wanted.size(); ++point) {
            text += "\r\n";
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const double value = columns[i].coordinate == 3 ? static_cast<double>(point)
                                                                : wanted[point][columns[i].coordinate];
                text += (i == 0 ? "" : std::string(1, separator)) + number(value, mark);
            }
        }
        const PointFile read = read_point_file(text + "\n", "points.csv");
        ASSERT_EQ(read.points, wanted) << text;
        ASSERT_FALSE(read.notes.empty()) << text;
        EXPECT_NE(read.notes.back().find("'id'"), std::string::npos) << read.notes.back();
    }
}

TEST(PointFile, WithoutAHeaderTakesTheFirstThreeColumnsAndSaysSo) {
    const PointFile read =
        read_point_file("0.25 0.75 300 17 18\n0.25 5.25 304 17 18\n4.5 5.25 307.5 1 2\n", "a.xyz");
    EXPECT_EQ(read.points, wanted);
    EXPECT_EQ(read.notes, std::vector<std::string>{
                              "a.xyz: no header: the first three of 5 columns are taken as x, y and z"});
    EXPECT_TRUE(read_point_file("1 2 3\n4 5 6\n", "a.xyz").notes.empty());
}

TEST(PointFile, ReadsDecimalCommas) {
    EXPECT_EQ(read_point_file("0,25;0,75;300,00\n0,25;5,25;304,00\n4,5;5,25;307,5\n", "a").points, wanted);
    EXPECT_EQ(read_point_file("0,25 0,75 300\n0,25 5,25 304\n4,5 5,25 307,5\n", "a").points, wanted);
    EXPECT_EQ(read_point_file("0.25,0.75,300\n0.25, 5.25, 304\n4.5,5.25,307.5\n", "a").points, wanted);
}

TEST(PointFile, ReadsAHeaderBehindACommentSign) {
    EXPECT_EQ(read_point_file("# z x y\n300 0.25 0.75\n304 0.25 5.25\n307.5 4.5 5.25\n", "a").points, wanted);
    EXPECT_EQ(read_point_file("//Z,X,Y\n300,0.25,0.75\n304,0.25,5.25\n307.5,4.5,5.25\n", "a").points, wanted);
    EXPECT_EQ(read_point_file("# of the survey, in May\n0.25 0.75 300\n0.25 5.25 304\n4.5 5.25 307.5\n", "a")
                  .points,
              wanted);
}

}  // namespace
}  // namespace coupling::point_file_test
