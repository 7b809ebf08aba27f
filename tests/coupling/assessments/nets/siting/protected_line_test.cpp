#include "coupling/assessments/nets/siting/protected_line.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"

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
