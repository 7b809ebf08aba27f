#include "forest/light/horizon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace horizon_test {
namespace {

using config::Angle;
using forest::Horizon;
using forest::horizon_at;

config::Raster<double> heights(double (*height)(double, double)) {
    config::Raster<double> raster{{201, 201, 0.0, 0.0, 10.0, 10.0}};
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const config::Cell at = raster.frame.cell_of(i);
        raster.values[i] = height(raster.frame.x_centre_m(at.column), raster.frame.y_centre_m(at.row));
    }
    return raster;
}

TEST(Horizon, IsLevelOnAPlain) {
    const Horizon horizon = horizon_at(heights([](double, double) { return 700.0; }), 1005.0, 1005.0);
    for (const float tangent : horizon.tangents()) {
        EXPECT_EQ(tangent, 0.0F);
    }
}

TEST(Horizon, IsTheSlopeOnAPlane) {
    const Horizon horizon = horizon_at(heights([](double, double y) { return 0.7 * y; }), 1005.0, 1005.0);
    EXPECT_NEAR(horizon.tangents()[0], 0.7, 1e-5);
    EXPECT_NEAR(horizon.tangents()[9], 0.0, 1e-5);
    EXPECT_NEAR(horizon.tangents()[18], -0.7, 1e-5);
    EXPECT_NEAR(horizon.tangent_at(Angle::from_degrees(5.0)), 0.7 * (1.0 + std::cos(0.1745)) / 2.0, 0.01);
}

TEST(Horizon, SeesAWallInTheEast) {
    const Horizon horizon =
        horizon_at(heights([](double x, double) { return x > 1500.0 ? 400.0 : 0.0; }), 1005.0, 1005.0);
    EXPECT_NEAR(horizon.tangents()[9], 0.8, 0.02);
    EXPECT_EQ(horizon.tangents()[27], 0.0F);
    const Angle east = Angle::from_degrees(90.0);
    EXPECT_FALSE(horizon.clears(forest::direction_at(east, Angle::from_degrees(37.0)), east));
    EXPECT_TRUE(horizon.clears(forest::direction_at(east, Angle::from_degrees(41.0)), east));
}

TEST(Horizon, LooksPastCellsWithoutHeight) {
    config::Raster<double> raster = heights([](double x, double) { return x > 1500.0 ? 400.0 : 0.0; });
    for (int row = 0; row < raster.frame.rows; ++row) {
        raster.at({120, row}) = std::numeric_limits<double>::quiet_NaN();
    }
    EXPECT_NEAR(horizon_at(raster, 1005.0, 1005.0).tangents()[9], 0.8, 0.02);
    EXPECT_EQ(horizon_at(raster, 1205.0, 1005.0).tangents()[9], 0.0F);  // no height of its own
    EXPECT_EQ(horizon_at(raster, -50.0, 1005.0).tangents()[9], 0.0F);   // outside
}

}  // namespace

}  // namespace horizon_test
