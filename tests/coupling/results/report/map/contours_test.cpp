#include "coupling/results/report/map/contours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

namespace coupling::report::contours_test {
namespace {

/// An even slope of 45 degrees to the south.
config::Raster<double> slope() {
    config::Raster<double> heights{{6, 6, 0.0, 0.0, 10.0, 10.0}};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        heights.values[i] = 100.0 + heights.frame.y_centre_m(heights.frame.cell_of(i).row);
    }
    return heights;
}

DrawnPoint as_it_is(double x_m, double y_m) {
    return {x_m, y_m};
}

TEST(Contours, LieWhereTheGroundHasTheirHeight) {
    // 110, 120, ... 150 m lie at y = 10, 20, ... 50, from the first to the last centre of a row.
    const std::string path = contours(slope(), 10.0, as_it_is);
    const std::regex places{"M([0-9.]+) ([0-9.]+)"};
    std::size_t found = 0;
    for (std::sregex_iterator at{path.begin(), path.end(), places}; at != std::sregex_iterator{}; ++at) {
        EXPECT_NEAR(std::remainder(std::stod((*at)[2]), 10.0), 0.0, 0.05) << at->str();
        ++found;
    }
    EXPECT_GE(found, 4U);
}

TEST(Contours, LeaveOutSquaresWithoutHeights) {
    config::Raster<double> heights = slope();
    EXPECT_FALSE(contours(heights, 10.0, as_it_is).empty());
    std::fill(heights.values.begin(), heights.values.end(), std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(contours(heights, 10.0, as_it_is).empty());
}

TEST(ContourStep, IsRoundAndLeavesAboutADozenContours) {
    config::Raster<double> heights = slope();
    EXPECT_EQ(contour_step_m(heights), 5.0);  // over 50 m
    for (double& height_m : heights.values) {
        height_m *= 20.0;
    }
    EXPECT_EQ(contour_step_m(heights), 100.0);
    std::fill(heights.values.begin(), heights.values.end(), 7.0);
    EXPECT_EQ(contour_step_m(heights), 1.0);
}

}  // namespace
}  // namespace coupling::report::contours_test
