#include "coupling/assessments/consequences/consequence.hpp"

#include <gtest/gtest.h>

#include <array>

namespace coupling::consequences::consequence_test {
namespace {

const CurveClass middle{
    .energy_from_kj = 30.0, .lethality_in_vehicle = 0.5, .lethality_in_house = 0.04, .damage_to_house = 0.2};

double of(const Quantities& quantities, Quantity quantity) {
    return quantities[index_of(quantity)];
}

TEST(Consequence, OfARoadIsPresenceTimesPersonsTimesLethality) {
    const TargetExposure road{
        .vehicles_per_day = 2400.0, .speed_kmph = 50.0, .persons_per_vehicle = 1.5, .vehicle_length_m = 4.0};
    const RiskSettings settings{
        .passages_per_day = 4.0, .prevented_death = 2e6, .closure_days = 0.5, .closure_cost_per_day = 1000.0};
    const Quantities found = consequence(road, middle, 1.0, settings);
    // 2400 (4 + 1) / (24 * 1000 * 50) = 0.01.
    EXPECT_NEAR(of(found, Quantity::vehicles_hit), 0.01, 1e-15);
    EXPECT_NEAR(of(found, Quantity::deaths), 0.01 * 1.5 * 0.5, 1e-15);
    EXPECT_NEAR(of(found, Quantity::individual_risk), 4.0 / 2400.0 * 0.01 * 0.5, 1e-15);
    EXPECT_EQ(of(found, Quantity::damage), 0.0);
    EXPECT_EQ(of(found, Quantity::closure_days), 0.5);
    EXPECT_EQ(of(found, Quantity::closure), 500.0);
    EXPECT_NEAR(of(found, Quantity::money), 0.0075 * 2e6 + 500.0, 1e-9);
}

/// A house without persons has no deaths to speak of, which is not 0 of them.
TEST(Consequence, CountsOnlyWhatATargetHas) {
    const TargetExposure road{.vehicles_per_day = 2400.0, .speed_kmph = 50.0, .persons_per_vehicle = 1.5};
    const TargetExposure barn{.house_value = 1e5};
    const TargetExposure home{.persons = 4.0, .hours_per_day = 16.0};
    const RiskSettings no_closure{};
    const RiskSettings closes{.closure_days = 0.5, .closure_cost_per_day = 1000.0};
    for (const Quantity quantity : {Quantity::closure, Quantity::closure_days}) {
        EXPECT_FALSE(has_what_counts(road, quantity, no_closure)) << "not counted, which is not 0";
        EXPECT_TRUE(has_what_counts(road, quantity, closes));
        EXPECT_FALSE(has_what_counts(home, quantity, closes));
    }
    EXPECT_TRUE(has_what_counts(road, Quantity::deaths, no_closure));
    EXPECT_FALSE(has_what_counts(road, Quantity::damage, no_closure));
    EXPECT_FALSE(has_what_counts(barn, Quantity::deaths, no_closure));
    EXPECT_FALSE(has_what_counts(barn, Quantity::individual_risk, no_closure));
    EXPECT_TRUE(has_what_counts(barn, Quantity::damage, no_closure));
    EXPECT_TRUE(has_what_counts(home, Quantity::deaths, no_closure));
    EXPECT_FALSE(has_what_counts(home, Quantity::damage, no_closure));
    EXPECT_FALSE(has_what_counts(home, Quantity::closure, no_closure));
    for (const TargetExposure& target : {road, barn, home}) {
        EXPECT_TRUE(has_what_counts(target, Quantity::arrivals, no_closure));
        EXPECT_TRUE(has_what_counts(target, Quantity::money, no_closure));
    }
    EXPECT_TRUE(any_has_what_counts(std::array{barn, home}, Quantity::deaths, no_closure));
    EXPECT_FALSE(any_has_what_counts(std::array{barn, barn}, Quantity::deaths, no_closure));
}

TEST(Consequence, OfARoadTakesTheLengthOfTheSettingsWhereTheTargetSaysNone) {
    TargetExposure road{.vehicles_per_day = 100.0, .speed_kmph = 50.0, .persons_per_vehicle = 1.0};
    const RiskSettings settings{.vehicle_length_m = 12.0};
    const Quantities by_setting = consequence(road, middle, 1.0, settings);
    road.vehicle_length_m = 12.0;
    EXPECT_EQ(consequence(road, middle, 1.0, settings), by_setting);
    road.vehicle_length_m = 5.0;
    EXPECT_LT(of(consequence(road, middle, 1.0, settings), Quantity::deaths),
              of(by_setting, Quantity::deaths));
}

TEST(Consequence, OfAHouseIsPersonsTimesTheirDayTimesLethality) {
    const TargetExposure house{.persons = 4.0, .hours_per_day = 18.0, .house_value = 800'000.0};
    const RiskSettings settings{.prevented_death = 1e6, .closure_days = 1.0, .closure_cost_per_day = 1000.0};
    const Quantities found = consequence(house, middle, 1.0, settings);
    EXPECT_NEAR(of(found, Quantity::individual_risk), 0.75 * 0.04, 1e-15);
    EXPECT_NEAR(of(found, Quantity::deaths), 4.0 * 0.75 * 0.04, 1e-15);
    EXPECT_NEAR(of(found, Quantity::damage), 160'000.0, 1e-9);
    EXPECT_EQ(of(found, Quantity::closure), 0.0);
    EXPECT_EQ(of(found, Quantity::vehicles_hit), 0.0);
    EXPECT_NEAR(of(found, Quantity::money), 120'000.0 + 160'000.0, 1e-6);
}

TEST(Consequence, OfAHouseWithoutPersonsIsDamageAlone) {
    const TargetExposure barn{.house_value = 1000.0};
    const Quantities found = consequence(barn, middle, 1.0, {});
    EXPECT_EQ(of(found, Quantity::deaths), 0.0);
    EXPECT_EQ(of(found, Quantity::money), 200.0);
}

}  // namespace
}  // namespace coupling::consequences::consequence_test
