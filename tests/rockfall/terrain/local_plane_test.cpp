#include "rockfall/terrain/local_plane.hpp"

#include <gtest/gtest.h>

namespace rockfall::local_plane_test {
namespace {

TEST(LocalPlane, PassesThroughThreePoints) {
    LocalPlane plane;
    plane.add(1.0, 0.0, 5.0, 0.2);
    plane.add(0.0, 1.0, 7.0, 1.0);
    plane.add(1.0, 1.0, 9.0, 3.0);
    // z = 3 + 2 x + 4 y
    EXPECT_NEAR(plane.height_at_centre_m().value(), 3.0, 1e-12);
}

TEST(LocalPlane, BalancesResidualsByWeight) {
    LocalPlane plane;
    for (const double x_m : {-1.0, 1.0}) {
        for (const double y_m : {-1.0, 1.0}) {
            plane.add(x_m, y_m, 0.0, 1.0);
        }
    }
    plane.add(0.0, 0.0, 1.0, 4.0);
    EXPECT_NEAR(plane.height_at_centre_m().value(), 0.5, 1e-12);
}

TEST(LocalPlane, IsUnknownForPointsInALine) {
    LocalPlane plane;
    plane.add(0.0, 0.0, 1.0, 1.0);
    EXPECT_FALSE(plane.height_at_centre_m());
    plane.add(1.0, 2.0, 3.0, 1.0);
    plane.add(-2.0, -4.0, 2.0, 1.0);
    EXPECT_FALSE(plane.height_at_centre_m());
    plane.add(1.0, 0.0, 2.0, 1.0);
    EXPECT_TRUE(plane.height_at_centre_m());
}

}  // namespace
}  // namespace rockfall::local_plane_test
