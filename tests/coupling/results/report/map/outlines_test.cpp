#include "coupling/results/report/map/outlines.hpp"

#include <gtest/gtest.h>

namespace coupling::report::outlines_test {
namespace {

TEST(PathText, GoesOnWhereTheLastLineEnded) {
    PathText path;
    path.line(0.0, 0.0, 10.0, 5.0);
    path.line(10.0, 5.0, 12.0, -1.0);
    path.line(20.0, 0.0, 21.0, 0.0);
    EXPECT_EQ(path.text(), "M0 0l10 5l2-6M20 0l1 0");
}

TEST(PathText, LeavesOutStepsOfNothing) {
    PathText path;
    path.line(0.0, 0.0, 0.01, 0.02);
    path.line(0.01, 0.02, 3.0, 0.0);
    EXPECT_EQ(path.text(), "M0 0l3 0");
}

config::Raster<std::uint8_t> grid() {
    return config::Raster<std::uint8_t>{{4, 3, 0.0, 0.0, 1.0, 1.0}, 0};
}

/// Sum of the lengths of the strokes: relative lines along the axes only.
double length_of(const std::string& path) {
    double sum = 0.0;
    for (std::size_t at = path.find('l'); at != std::string::npos; at = path.find('l', at + 1)) {
        char* rest = nullptr;
        const double dx = std::strtod(path.c_str() + at + 1, &rest);
        sum += std::abs(dx) + std::abs(std::strtod(rest, nullptr));
    }
    return sum;
}

TEST(Outlines, GoAroundASingleCell) {
    config::Raster<std::uint8_t> inside = grid();
    inside.at({1, 1}) = 1;
    EXPECT_EQ(outlines(inside, 10.0, 10.0), "M10 10l10 0M10 20l10 0M10 10l0 10M20 10l0 10");
}

TEST(Outlines, LeaveOutEdgesBetweenTwoCellsInside) {
    config::Raster<std::uint8_t> inside = grid();
    inside.at({1, 1}) = inside.at({2, 1}) = 1;
    EXPECT_DOUBLE_EQ(length_of(outlines(inside, 10.0, 10.0)), 60.0);
}

TEST(Outlines, CloseAtTheRimOfTheGrid) {
    config::Raster<std::uint8_t> inside{{4, 3, 0.0, 0.0, 1.0, 1.0}, 1};
    EXPECT_DOUBLE_EQ(length_of(outlines(inside, 10.0, 10.0)), 140.0);
}

TEST(Outlines, OfNothingAreNothing) {
    EXPECT_EQ(outlines(grid(), 10.0, 10.0), "");
}

}  // namespace
}  // namespace coupling::report::outlines_test
