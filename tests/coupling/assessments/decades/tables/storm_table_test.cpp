#include "coupling/assessments/decades/tables/storm_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "coupling/inputs/scenario/scenario.hpp"
#include "forest/disturbance/wind.hpp"

namespace coupling::decades::storm_table_test {
namespace {

std::unique_ptr<Scenario> stormy(double interval_years) {
    auto scenario = std::make_unique<Scenario>();
    scenario->run.seed = 7;
    scenario->run.years = 3;
    scenario->forest.replicates = 2;
    scenario->forest.parameters.disturbance.wind = true;
    scenario->forest.parameters.disturbance.storm_interval_years = interval_years;
    return scenario;
}

TEST(StormYears, AreThoseOfTheForestByReplicateAndCalendarYear) {
    // One storm a year: each year of each replicate has one. The first year of the run is 2025.
    const std::vector<StormYear> storms = storm_years(*stormy(1.0), 2025);
    ASSERT_EQ(storms.size(), 6U);
    for (std::size_t i = 0; i < storms.size(); ++i) {
        const StormYear& storm = storms[i];
        EXPECT_EQ(storm.replicate, i / 3);
        EXPECT_EQ(storm.year, static_cast<std::int32_t>(i % 3) + 1);
        EXPECT_EQ(storm.calendar_year, 2024 + storm.year);
        const forest::DisturbanceLaw every_year{.wind = true, .storm_interval_years = 1.0};
        const auto law = forest::storm_of_year(every_year, 7, storm.replicate, storm.calendar_year);
        ASSERT_TRUE(law);
        EXPECT_EQ(storm.intensity, law->intensity);
        // Clockwise from north against counter-clockwise from east: sine and cosine change places.
        const double bearing_rad = storm.towards_deg * std::numbers::pi / 180.0;
        EXPECT_NEAR(std::sin(bearing_rad), std::cos(law->towards_rad), 1e-9);
        EXPECT_NEAR(std::cos(bearing_rad), std::sin(law->towards_rad), 1e-9);
        EXPECT_GE(storm.towards_deg, 0.0);
        EXPECT_LT(storm.towards_deg, 360.0);
    }
    EXPECT_NE(storms[0].intensity, storms[3].intensity) << "replicates have their own";
}

TEST(StormYears, AreNoneWithoutWind) {
    const auto calm = stormy(1.0);
    calm->forest.parameters.disturbance.wind = false;
    EXPECT_TRUE(storm_years(*calm, 2025).empty());
    EXPECT_TRUE(storm_years(*stormy(1e12), 2025).empty()) << "one in 10^12 years";
}

TEST(StormYears, HaveTheStormsThatWereAskedFor) {
    const auto asked = stormy(1e12);
    for (const bool by_chance : {true, false}) {
        asked->forest.parameters.disturbance.wind = by_chance;
        asked->forest.parameters.disturbance.storm_years = {2026.0, 2050.0};
        asked->forest.parameters.disturbance.intensity_asked_for = 0.7;
        asked->forest.parameters.disturbance.first_year = 2027;
        const std::vector<StormYear> storms = storm_years(*asked, 2025);
        ASSERT_EQ(storms.size(), 2U) << "one of each replicate; the other lies after the run";
        for (const StormYear& storm : storms) {
            EXPECT_EQ(storm.calendar_year, 2026);
            EXPECT_EQ(storm.intensity, 0.7);
        }
    }
}

}  // namespace
}  // namespace coupling::decades::storm_table_test
