#include "forest/climate/co2.hpp"

#include <gtest/gtest.h>

#include "tests/forest/climate/weather.hpp"

namespace forest::co2_test {
namespace {

TEST(Co2Series, RunsStraightBetweenItsYears) {
    const Co2Series co2 = Co2Series::shipped();
    EXPECT_DOUBLE_EQ(co2.ppm(1950), 310.0);
    EXPECT_DOUBLE_EQ(co2.ppm(1995), 360.0);
    EXPECT_DOUBLE_EQ(co2.ppm(2009), 390.0);
    EXPECT_DOUBLE_EQ(co2.ppm(2023), 420.0);
}

TEST(Co2Series, StaysAtItsEnds) {
    EXPECT_DOUBLE_EQ(Co2Series::shipped().ppm(1800), 310.0);
    EXPECT_DOUBLE_EQ(Co2Series::shipped().ppm(2100), 420.0);
    EXPECT_DOUBLE_EQ(Co2Series::constant(350.0).ppm(2050), 350.0);
}

TEST(Co2Series, WantsRisingYearsAndPartsPerMillion) {
    EXPECT_THROW(Co2Series::read(climate_table("year,co2\n2000,370\n1990,350\n")), config::InputError);
    EXPECT_THROW(Co2Series::read(climate_table("year,co2\n2000,0.037\n")), config::InputError);
    EXPECT_THROW(Co2Series::read(climate_table("year,co2\n")), config::InputError);
}

}  // namespace
}  // namespace forest::co2_test
