#include "coupling/assessments/nets/siting/protected_line.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::siting::protected_line_test {
namespace {

std::vector<ProtectedLine> read(const std::string& text, std::vector<std::string>& remarks) {
    return lines_of(config::Table::read(text, "road.csv"), remarks);
}

TEST(LinesOf, TakeARoadAsItIs) {
    std::vector<std::string> remarks;
    const auto lines = read(
        "target_id,name,wkt\n"
        "r1,road,\"LINESTRING (0 0, 10 0, 10 0, 20 0)\"\n"
        "r2,,\"MULTILINESTRING ((0 5, 9 5), (11 5, 20 5))\"\n"
        "h,house,\"POLYGON ((0 0, 1 0, 1 1, 0 0))\"\n",
        remarks);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].name, "road");
    EXPECT_EQ(lines[0].line_m.size(), 3U);  // a corner given twice is one
    EXPECT_EQ(lines[1].name, "r2, part 1");
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("house: an area, left out"), std::string::npos);
}

TEST(LinesOf, RefuseWhatIsNoLine) {
    std::vector<std::string> remarks;
    EXPECT_THROW(read("name\nroad\n", remarks), config::InputError);
    EXPECT_THROW(read("name,wkt\nroad,\"POINT (1 2)\"\n", remarks), config::InputError);
    EXPECT_THROW(read("name,wkt\nroad,\"LINESTRING (1 2, 1 2)\"\n", remarks), config::InputError);
    EXPECT_THROW(read("name,wkt\nhouse,\"POLYGON ((0 0, 1 0, 1 1, 0 0))\"\n", remarks), config::InputError);
}

TEST(ReadLines, LeavesOutWhatLiesWhollyBeyondTheTerrain) {
    const SampleProject project;
    const Opened opened = open(project);
    const rockfall::Terrain& terrain = opened.site->slope.terrain;
    std::vector<std::string> remarks;
    project.write("roads.csv",
                  "name,wkt\nfar,\"LINESTRING (1300 2010, 1300 2090)\"\n"
                  "road,\"LINESTRING (1105 2010, 1105 2090)\"\n");
    const GivenLines given = read_lines(project.file("roads.csv"), {terrain}, remarks);
    ASSERT_EQ(given.lines.size(), 1U);
    EXPECT_EQ(given.lines[0].name, "road");
    EXPECT_EQ(given.lines[0].line_m[0].x() + terrain.origin_m().x(), 1105.0);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_TRUE(
        remarks[0].ends_with("roads.csv: 1 of 2 lines wholly beyond the terrain; left out, such as 'far'"))
        << remarks[0];
    project.replace("roads.csv", "1300 2010, 1300 2090", "2010 1105, 2090 1105");
    EXPECT_THROW(read_lines(project.file("roads.csv"), {terrain}, remarks), config::InputError)
        << "exchanged axes are none of a larger layer";
}

TEST(PieceOf, GoesStraightOnBeyondTheEnds) {
    const std::vector<Eigen::Vector2d> line{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};
    const auto piece = piece_of(line, -5.0, 25.0);
    ASSERT_EQ(piece.size(), 3U);
    EXPECT_EQ(piece.front(), Eigen::Vector2d(-5.0, 0.0));
    EXPECT_EQ(piece.back(), Eigen::Vector2d(10.0, 15.0));
    EXPECT_EQ(length_m(piece), 30.0);
    const auto inside = piece_of(line, 2.0, 8.0);
    ASSERT_EQ(inside.size(), 2U);
    EXPECT_EQ(length_m(inside), 6.0);
}

}  // namespace
}  // namespace coupling::siting::protected_line_test
