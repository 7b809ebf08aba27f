#include "coupling/results/report/map/hillshade.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coupling::report::hillshade_test {
namespace {

const config::GridFrame frame{5, 5, 0.0, 0.0, 10.0, 10.0};

/// A plane that rises by these tangents to the east and to the north.
config::Raster<double> plane(double to_east, double to_north) {
    config::Raster<double> heights{frame};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        heights.values[i] = to_east * frame.x_centre_m(cell.column) + to_north * frame.y_centre_m(cell.row);
    }
    return heights;
}

constexpr config::Cell middle{2, 2};

TEST(Illumination, OfFlatGroundIsTheSineOfTheLightsAltitude) {
    EXPECT_NEAR(illumination(plane(0.0, 0.0)).at(middle), std::sin(M_PI / 4.0), 1e-6);
}

TEST(Illumination, IsFullOnASlopeThatFacesTheLight) {
    // Falls to the north-west at 45 degrees: the light from there stands normal to it.
    const double tangent = std::sqrt(0.5);
    EXPECT_NEAR(illumination(plane(tangent, -tangent)).at(middle), 1.0, 1e-6);
}

TEST(Illumination, IsNoneOnASlopeThatTurnsItsBack) {
    EXPECT_NEAR(illumination(plane(-1.0, 1.0)).at(middle), 0.0, 1e-6);
}

TEST(Illumination, FollowsTheLight) {
    const Light from_east{config::Angle::from_degrees(90.0), config::Angle::from_degrees(45.0)};
    EXPECT_NEAR(illumination(plane(-1.0, 0.0), from_east).at(middle), 1.0, 1e-6);
}

TEST(Illumination, IsUnknownWithoutHeights) {
    config::Raster<double> heights = plane(0.3, 0.2);
    heights.at(middle) = std::nan("");
    const config::Raster<float> lit = illumination(heights);
    EXPECT_TRUE(std::isnan(lit.at(middle)));
    EXPECT_FALSE(std::isnan(lit.at({1, 2}))) << "its neighbours are still shaded";
    EXPECT_EQ(hillshade(lit).pixels[frame.index(middle)], 255);
}

}  // namespace
}  // namespace coupling::report::hillshade_test
