#include "forest/production/soil.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace forest::soil_test {
namespace {

const SoilTexture silty_clay_loam{10.0, 60.0, 30.0};
const SoilTexture loam{47.5, 32.5, 20.0};

TEST(SoilRetention, ReadsBackItsWater) {
    const SoilRetention retention = retention_of(loam);
    for (const double potential_kpa : {-15.0, -100.0, -1500.0, -4000.0}) {
        EXPECT_NEAR(retention.potential_kpa(retention.water_at(potential_kpa)), potential_kpa,
                    1e-9 * -potential_kpa);
    }
    EXPECT_DOUBLE_EQ(retention.water_at(-1e-6), retention.saturated_water) << "no more than it can hold";
}

TEST(SoilRetention, HoldsMoreInClayThanInSand) {
    const SoilTexture sand{90.0, 5.0, 5.0};
    const SoilTexture clay{15.0, 25.0, 60.0};
    EXPECT_GT(retention_of(clay).water_at(-4000.0), retention_of(sand).water_at(-4000.0));
    EXPECT_GT(retention_of(clay).exponent, retention_of(sand).exponent);
}

TEST(SoilRetention, IsThatOfCosby) {
    // -0.098 kPa for each of 10^(1.54 - 0.0095 * 47.5 + 0.0063 * 32.5) cm of water.
    const SoilRetention retention = retention_of(loam);
    EXPECT_NEAR(retention.saturated_potential_kpa, -0.098 * std::pow(10.0, 1.2935), 1e-10);
    EXPECT_NEAR(retention.exponent, 6.0975, 1e-12);
    EXPECT_NEAR(retention.saturated_water, 0.43015, 1e-12);
}

TEST(AvailableWater, OfTheLimestoneAlpsIsThatOfVeryShallowSoils) {
    // The two cells of the Kalkalpen: 11 cm of silty clay loam, 19 cm of loam.
    const double first_mm = available_water_mm(silty_clay_loam, 11.28, 0.0);
    const double second_mm = available_water_mm(loam, 18.8, 0.0);
    EXPECT_GT(first_mm, 15.0);
    EXPECT_LT(first_mm, 35.0);
    EXPECT_GT(second_mm, 30.0);
    EXPECT_LT(second_mm, 60.0);
    EXPECT_NEAR(available_water_mm(loam, 18.8, 0.5), 0.5 * second_mm, 1e-12);
}

TEST(SoilClass, FollowsTexture) {
    EXPECT_EQ(soil_class_of({90.0, 5.0, 5.0}), 1);
    EXPECT_EQ(soil_class_of({60.0, 30.0, 10.0}), 2);
    EXPECT_EQ(soil_class_of(silty_clay_loam), 3);
    EXPECT_EQ(soil_class_of({20.0, 20.0, 60.0}), 4);
}

TEST(SoilTexture, MustSumToAHundred) {
    EXPECT_NO_THROW(check(loam, {}));
    EXPECT_THROW(check({50.0, 30.0, 10.0}, {"soil.csv", 2, 3}), config::InputError);
    EXPECT_THROW(check({120.0, -40.0, 20.0}, {}), config::InputError);
}

TEST(SoilTypes, ShipFourFromScreeToDeepLoam) {
    const std::vector<SoilType> types = shipped_soil_types();
    ASSERT_EQ(types.size(), 4U);
    EXPECT_EQ(types.front().name, "scree");
    EXPECT_DOUBLE_EQ(types.back().water_capacity_mm, 200.0);
    std::istringstream in{"name,water_capacity,soil_class,fertility\nrock,-5,7,0.2\n"};
    EXPECT_THROW(read_soil_types(config::Table::read(in, "soils.csv")), config::InputError);
}

}  // namespace
}  // namespace forest::soil_test
