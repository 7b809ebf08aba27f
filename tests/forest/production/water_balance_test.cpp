#include "forest/production/water_balance.hpp"

#include <gtest/gtest.h>

#include <array>

#include "config/random/stream.hpp"
#include "forest/production/day_length.hpp"

namespace forest::water_balance_test {
namespace {

const config::Angle tyrol = config::Angle::from_degrees(47.0);

ClimateMonth weather(double tave_degc, double prec_mm, double radiation_mjpm2, double vpd_kpa) {
    ClimateMonth month;
    month.tave_degc = tave_degc;
    month.tmin_degc = tave_degc - 5.0;
    month.tmax_degc = tave_degc + 5.0;
    month.prec_mm = prec_mm;
    month.radiation_mjpm2 = radiation_mjpm2;
    month.vpd_kpa = vpd_kpa;
    return month;
}

std::vector<WaterUse> spruce_and_beech(const ClimateMonth& month) {
    static const SpeciesTable species = SpeciesTable::shipped();
    return {water_use(species[species.find("piab").value()], month, 1.0, 350.0),
            water_use(species[species.find("fasy").value()], month, 1.0, 350.0)};
}

const WaterStore brown_soil{120.0, soil_potential_of(3)};

/// A month of spruce and beech.
struct TwoSpecies {
    WaterFlows flows;
    std::array<double, 2> response{};
};

TwoSpecies month_of(WaterState& state, const WaterMonth& month, std::span<const WaterUse> uses,
                    std::span<const double> lai, double ground_light) {
    TwoSpecies result;
    result.flows = balance_month(state, month, brown_soil, uses, lai, ground_light, result.response);
    return result;
}

TEST(WaterBalance, ClosesInEveryMonthOfAnyWeather) {
    config::RandomStream random{{.seed = 5}, config::Purpose::test};
    WaterState state{60.0, 0.0};
    for (int i = 0; i < 5000; ++i) {
        const int month = 1 + i % 12;
        const ClimateMonth climate = weather(-15.0 + 40.0 * random.uniform(), 300.0 * random.uniform(),
                                             2.0 + 25.0 * random.uniform(), 1.5 * random.uniform());
        const WaterMonth water =
            water_month(climate, month, day_length_s(tyrol, month), 0.3 + random.uniform());
        const std::vector<WaterUse> uses = spruce_and_beech(climate);
        const std::array lai{6.0 * random.uniform(), i % 3 == 0 ? 0.0 : 5.0 * random.uniform()};
        const double before_mm = state.soil_mm + state.snow_mm;
        const auto [flows, response] = month_of(state, water, uses, lai, random.uniform());

        const double after_mm = state.soil_mm + state.snow_mm;
        EXPECT_NEAR(climate.prec_mm, flows.evapotranspiration_mm + flows.runoff_mm + after_mm - before_mm,
                    1e-9);
        EXPECT_GE(state.soil_mm, 0.0);
        EXPECT_LE(state.soil_mm, brown_soil.capacity_mm);
        EXPECT_GE(state.snow_mm, 0.0);
        EXPECT_GE(flows.supply, 0.0);
        EXPECT_LE(flows.supply, 1.0 + 1e-12);
        EXPECT_LE(flows.evapotranspiration_mm, flows.demand_mm + 1e-9);
        EXPECT_LE(response[0], response[1]);  // spruce closes its stomata before beech
        EXPECT_GE(response[0], 0.0);
        EXPECT_LE(response[1], 1.0);
    }
}

TEST(WaterBalance, RunsShortInADrySummer) {
    const ClimateMonth dry = weather(18.0, 0.0, 22.0, 1.2);
    const WaterMonth july = water_month(dry, 7, day_length_s(tyrol, 7), 1.0);
    const std::array lai{5.0, 0.0};
    WaterState state{120.0, 0.0};
    DroughtSum drought;
    double supply = 1.0;
    for (int month = 0; month < 6; ++month) {
        const WaterFlows flows = month_of(state, july, spruce_and_beech(dry), lai, 0.1).flows;
        drought.add(dry.tave_degc, flows);
        supply = flows.supply;
    }
    EXPECT_LE(supply, 1.0);
    EXPECT_GT(drought.index(), 0.5);
    EXPECT_LT(drought.index(), 1.0);
}

TEST(WaterUse, ClosesStomataInTheColdAndInTheHeat) {
    // Spruce: 2.5 to 30.1 degC, between the mean and the mean of the maxima (5 K above the mean here).
    EXPECT_DOUBLE_EQ(spruce_and_beech(weather(-0.1, 80.0, 8.0, 0.2))[0].limit, 0.0);
    EXPECT_DOUBLE_EQ(spruce_and_beech(weather(28.0, 80.0, 8.0, 0.2))[0].limit, 0.0);
    EXPECT_GT(spruce_and_beech(weather(3.0, 80.0, 8.0, 0.2))[0].limit, 0.0);
    EXPECT_DOUBLE_EQ(spruce_and_beech(weather(3.0, 80.0, 8.0, 0.2))[1].limit, 0.0);  // beech from 5.6 degC
}

TEST(WaterBalance, TranspiresNothingInTheColdAndMoreTheWarmerItIs) {
    // From the least temperature to the optimum, all else alike.
    double before_mm = 0.0;
    for (double tave_degc = -6.0; tave_degc < 21.0; tave_degc += 1.0) {
        const ClimateMonth climate = weather(tave_degc, 0.0, 14.0, 0.3);
        WaterState state{brown_soil.capacity_mm, 0.0};
        const double transpiration_mm = month_of(state, water_month(climate, 4, day_length_s(tyrol, 4), 1.0),
                                                 spruce_and_beech(climate), std::array{5.0, 0.0}, 0.1)
                                            .flows.transpiration_mm;
        const bool is_cold = tave_degc + 2.5 <= 2.4727;
        if (is_cold) {
            EXPECT_EQ(transpiration_mm, 0.0) << tave_degc;
        } else {
            EXPECT_GT(transpiration_mm, before_mm) << tave_degc;
        }
        before_mm = transpiration_mm;
    }
}

TEST(WaterBalance, KeepsSnowInWinterAndGivesItBackInSpring) {
    const ClimateMonth january = weather(-10.0, 80.0, 4.0, 0.1);
    WaterState state{120.0, 0.0};
    const std::array lai{4.0, 0.0};
    for (int month = 0; month < 3; ++month) {
        const WaterFlows flows = month_of(state, water_month(january, 1, day_length_s(tyrol, 1), 1.0),
                                          spruce_and_beech(january), lai, 0.1)
                                     .flows;
        EXPECT_LT(flows.runoff_mm, 5.0);
    }
    EXPECT_GT(state.snow_mm, 100.0);
    const ClimateMonth may = weather(9.0, 100.0, 18.0, 0.5);
    const WaterFlows flows =
        month_of(state, water_month(may, 5, day_length_s(tyrol, 5), 1.0), spruce_and_beech(may), lai, 0.1)
            .flows;
    EXPECT_GT(flows.runoff_mm, 80.0);
}

TEST(WaterBalance, TranspiresNothingUnderDeepSnow) {
    const ClimateMonth march = weather(-1.0, 60.0, 12.0, 0.3);
    WaterState state{100.0, 300.0};
    const WaterFlows flows = month_of(state, water_month(march, 3, day_length_s(tyrol, 3), 1.0),
                                      spruce_and_beech(march), std::array{4.0, 0.0}, 0.1)
                                 .flows;
    EXPECT_EQ(flows.transpiration_mm, 0.0);
    EXPECT_EQ(flows.soil_evaporation_mm, 0.0);
    EXPECT_GT(flows.interception_mm, 0.0);
}

TEST(WaterBalance, OfOpenGroundLosesWaterFromTheSoilOnly) {
    const ClimateMonth july = weather(16.0, 100.0, 20.0, 0.8);
    WaterState state{120.0, 0.0};
    const WaterFlows flows = month_of(state, water_month(july, 7, day_length_s(tyrol, 7), 1.0),
                                      spruce_and_beech(july), std::array{0.0, 0.0}, 1.0)
                                 .flows;
    EXPECT_EQ(flows.interception_mm, 0.0);
    EXPECT_EQ(flows.transpiration_mm, 0.0);
    EXPECT_GT(flows.soil_evaporation_mm, 20.0);
    EXPECT_LT(flows.soil_evaporation_mm, 120.0);
}

TEST(WaterBalance, OfASunnySlopeIsDrier) {
    const ClimateMonth july = weather(16.0, 60.0, 20.0, 0.9);
    const std::array lai{4.0, 1.0};
    WaterState south{120.0, 0.0};
    WaterState north{120.0, 0.0};
    const double day_s = day_length_s(tyrol, 7);
    month_of(south, water_month(july, 7, day_s, 1.1), spruce_and_beech(july), lai, 0.1);
    month_of(north, water_month(july, 7, day_s, 0.6), spruce_and_beech(july), lai, 0.1);
    EXPECT_LT(south.soil_mm, north.soil_mm);
}

TEST(WaterBalance, DemandIsThatOfASoilAtCapacity) {
    const ClimateMonth dry = weather(18.0, 30.0, 22.0, 1.2);
    const WaterMonth july = water_month(dry, 7, day_length_s(tyrol, 7), 1.0);
    const std::array lai{5.0, 0.0};
    WaterState full{120.0, 0.0};
    WaterState empty{5.0, 0.0};
    const WaterFlows of_full = month_of(full, july, spruce_and_beech(dry), lai, 0.1).flows;
    const WaterFlows of_empty = month_of(empty, july, spruce_and_beech(dry), lai, 0.1).flows;
    EXPECT_DOUBLE_EQ(of_full.demand_mm, of_empty.demand_mm);
    EXPECT_LT(of_empty.evapotranspiration_mm, 0.5 * of_empty.demand_mm);
    EXPECT_GT(of_full.evapotranspiration_mm, 0.5 * of_full.demand_mm);
}

TEST(DroughtSum, CountsWarmMonthsOnly) {
    WaterFlows half;
    half.demand_mm = 100.0;
    half.evapotranspiration_mm = 50.0;
    DroughtSum drought;
    EXPECT_EQ(drought.index(), 0.0);
    drought.add(3.0, half);
    EXPECT_EQ(drought.index(), 0.0);
    drought.add(12.0, half);
    EXPECT_DOUBLE_EQ(drought.index(), 0.5);
}

}  // namespace
}  // namespace forest::water_balance_test
