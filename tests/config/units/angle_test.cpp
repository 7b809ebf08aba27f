#include "config/units/angle.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace config::angle_test {
namespace {

TEST(Angle, ReadsTheSameInBothUnits) {
    EXPECT_DOUBLE_EQ(Angle::from_degrees(180.0).in_radians(), std::numbers::pi);
    EXPECT_DOUBLE_EQ(Angle::from_radians(std::numbers::pi / 2.0).in_degrees(), 90.0);
    EXPECT_EQ(Angle{}.in_degrees(), 0.0);
}

}  // namespace
}  // namespace config::angle_test
