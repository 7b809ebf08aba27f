#include "forest/production/day_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace forest::day_length_test {
namespace {

double hours(double latitude_deg, int month) {
    return day_length_s(config::Angle::from_degrees(latitude_deg), month) / 3600.0;
}

TEST(DayLength, IsTwelveHoursAtTheEquatorAlways) {
    for (int month = 1; month <= 12; ++month) {
        EXPECT_NEAR(hours(0.0, month), 12.0, 1e-9) << month;
    }
}

TEST(DayLength, EqualsTheFormulaWithTheLibrarysFunctions) {
    constexpr int middle[] = {15, 46, 74, 105, 135, 166, 196, 227, 258, 288, 319, 349};
    for (double latitude_deg = -60.0; latitude_deg <= 60.0; latitude_deg += 7.5) {
        const double latitude = latitude_deg * M_PI / 180.0;
        for (int month = 1; month <= 12; ++month) {
            const double s = 0.4 * std::sin(0.0172 * (middle[month - 1] - 80));
            const double c = -s * std::sin(latitude) / (std::cos(latitude) * std::sqrt(1.0 - s * s));
            EXPECT_NEAR(hours(latitude_deg, month), 24.0 * std::acos(c) / M_PI, 1e-8)
                << latitude_deg << " in month " << month;
        }
    }
}

TEST(DayLength, KnowsPolarDayAndNight) {
    EXPECT_DOUBLE_EQ(hours(80.0, 6), 24.0);
    EXPECT_DOUBLE_EQ(hours(80.0, 12), 0.0);
    EXPECT_DOUBLE_EQ(hours(-80.0, 12), 24.0);
}

}  // namespace
}  // namespace forest::day_length_test
