#include "validation/engine/forest_cases/mapped_stand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "validation/engine/forest_cases/light_agreement.hpp"

namespace coupling::validation::forest_cases::mapped_stand_test {
namespace {

config::Table table(const std::string& name) {
    std::ifstream in{std::string{BANNWALD_SOURCE_DIR} + "/validation/forest_light/" + name};
    return config::Table::read(in, name);
}

const MappedStand& prenovel() {
    static const MappedStand stand =
        mapped_stand({table("trees.csv"), table("leaves.csv"), table("radiation.csv"), table("slopes.csv"),
                      table("ground.csv")});
    return stand;
}

LightAgreement printed(const MappedSlope& slope, const MappedSettings& settings) {
    const LightAgreement agreement = compare_light(prenovel(), slope, settings);
    std::cout << std::fixed << std::setprecision(3) << slope.name << ", columns of " << settings.column_m
              << " m: energy " << agreement.energy_direct_ratio << " direct, "
              << agreement.energy_diffuse_ratio << " diffuse; ground light " << agreement.ground_light << " ("
              << std::showpos << agreement.ground_light_difference << std::noshowpos << "); trees r "
              << agreement.tree_light_correlation << ", bias " << agreement.tree_light_bias << ", RMSE "
              << agreement.tree_light_rmse << '\n';
    return agreement;
}

TEST(MappedStand, HasTheStandOfTheReference) {
    EXPECT_EQ(prenovel().trees.size(), 333U);
    ASSERT_EQ(prenovel().slopes.size(), 3U);
    EXPECT_EQ(prenovel().slopes[0].ground_light.size(), 400U);
}

/// The stand with a table of its own for the slopes or the radiation.
MappedStand stand_with(const std::string& slopes, const std::string& radiation = {}) {
    std::istringstream slopes_in{
        "slope,latitude_deg,side_m,slope_deg,aspect_deg,y_axis_azimuth_deg,"
        "direct_mjpm2,diffuse_mjpm2\n" +
        slopes};
    std::istringstream radiation_in{radiation};
    return mapped_stand(
        {table("trees.csv"), table("leaves.csv"),
         radiation.empty() ? table("radiation.csv") : config::Table::read(radiation_in, "radiation.csv"),
         config::Table::read(slopes_in, "slopes.csv"), table("ground.csv")});
}

TEST(MappedStand, LiesWhereItsTableSays) {
    const MappedStand stand = stand_with("slope_6,-15.5,110,6,144,324,2439.9,2095.3\n");
    EXPECT_DOUBLE_EQ(stand.latitude.in_degrees(), -15.5);
    EXPECT_DOUBLE_EQ(stand.side_m, 110.0);
}

TEST(MappedStand, GetsLessDirectLightOnANorthSlopeFurtherNorth) {
    // The same radiation on the flat; a slope of 35 deg to the north faces away from a lower sun.
    const auto direct = [](const std::string& latitude) {
        const MappedStand stand = stand_with("slope_35_north," + latitude + ",100,35,0,0,1060.5,1844.6\n");
        return compare_light(stand, stand.slopes[0]).energy_direct_ratio;
    };
    EXPECT_LT(direct("60"), 0.9 * direct("40"));
}

config::Table sensors_of(const std::string& rows) {
    std::istringstream in{"sensor,x_m,y_m,light_slope_6\n" + rows};
    return config::Table::read(in, "sensors.csv");
}

MappedStand stand_with_sensors(const std::string& rows) {
    std::istringstream slopes{
        "slope,latitude_deg,side_m,slope_deg,aspect_deg,y_axis_azimuth_deg\nslope_6,46.5,100,6,144,324\n"};
    return mapped_stand({.trees = table("trees.csv"),
                         .leaves = table("leaves.csv"),
                         .radiation = table("radiation.csv"),
                         .slopes = config::Table::read(slopes, "slopes.csv"),
                         .sensors = sensors_of(rows)});
}

TEST(CompareLight, TakesSensorsAlone) {
    // The reference of two ground cells as if sensors stood in their middles, and one on the edge.
    const MappedStand stand = stand_with_sensors("a,2.5,97.5,0.08837\nb,52.5,97.5,0.2\nc,100,0,0.1\n");
    ASSERT_EQ(stand.sensors.size(), 3U);
    const LightAgreement agreement = compare_light(stand, stand.slopes[0]);
    ASSERT_EQ(agreement.sensor_light.size(), 3U);
    double bias = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double difference = agreement.sensor_light[i] - stand.slopes[0].sensor_light[i];
        EXPECT_GT(agreement.sensor_light[i], 0.0);
        EXPECT_LT(agreement.sensor_light[i], 1.0);
        bias += difference / 3.0;
        squares += difference * difference / 3.0;
    }
    EXPECT_NEAR(agreement.sensor_bias, bias, 1e-12);
    EXPECT_NEAR(agreement.sensor_rmse, std::sqrt(squares), 1e-12);
    EXPECT_EQ(agreement.energy_direct_ratio, 0.0) << "no reference";
    EXPECT_EQ(agreement.ground_light_difference, 0.0);
}

TEST(CompareLight, TakesTheColumnThatASensorStandsIn) {
    const MappedStand stand = stand_with_sensors("a,2.5,97.5,0.1\nb,7.5,92.5,0.1\nc,7.5,87.5,0.1\n");
    const LightAgreement wide = compare_light(stand, stand.slopes[0]);
    EXPECT_EQ(wide.sensor_light[0], wide.sensor_light[1]) << "the same 10 m";
    EXPECT_NE(wide.sensor_light[0], wide.sensor_light[2]);
}

TEST(CompareLight, KnowsNoCorrelationOfFewPlacesOrWithoutSpread) {
    const MappedStand two = stand_with_sensors("a,2.5,97.5,0.1\nb,52.5,97.5,0.2\n");
    EXPECT_TRUE(std::isnan(compare_light(two, two.slopes[0]).sensor_correlation));
    EXPECT_EQ(why_no_correlation(two, two.slopes[0], 10.0),
              "a correlation needs 3 places or more, and there are 2");
    const MappedStand even = stand_with_sensors("a,2.5,97.5,0.1\nb,52.5,97.5,0.1\nc,9,9,0.1\n");
    EXPECT_TRUE(std::isnan(compare_light(even, even.slopes[0]).sensor_correlation));
    EXPECT_EQ(why_no_correlation(even, even.slopes[0], 10.0),
              "the reference light is the same at all places");
    const MappedStand near = stand_with_sensors("a,99,1,0.1\nb,100,6,0.2\nc,92,1,0.3\n");
    EXPECT_EQ(why_no_correlation(near, near.slopes[0], 10.0),
              "all sensors stand in one column of light of 10 m");
    EXPECT_EQ(why_no_correlation(near, near.slopes[0], 5.0), "");
    EXPECT_TRUE(std::isfinite(
        compare_light(near, near.slopes[0], {.column_m = 5.0, .ground_points = 2}).sensor_correlation));
}

TEST(MappedStand, WarnsOfColumnsThatNothingReads) {
    MappedTables tables{table("trees.csv"), table("leaves.csv"), table("radiation.csv"), table("slopes.csv"),
                        table("ground.csv")};
    config::Warnings none;
    warn_of_unknown_columns(tables, none);
    EXPECT_TRUE(none.all().empty()) << none.all().front();
    tables.sensors =
        config::Table::read(std::string_view{"x_m,y_m,light_slop_6,remark\n1,1,0.5,\n"}, "sensors.csv");
    config::Warnings warnings;
    warn_of_unknown_columns(tables, warnings);
    ASSERT_EQ(warnings.all().size(), 1U);
    EXPECT_EQ(
        warnings.all()[0],
        "sensors.csv: column 'light_slop_6' is not read; if it is 'light_slope_6', give it that name, or "
        "leave it out");
}

TEST(CompareLight, AgreesInColumnsOfTenMetres) {
    for (const MappedSlope& slope : prenovel().slopes) {
        const bool south = slope.name == "slope_35_south";
        const LightAgreement agreement = printed(slope, {});
        EXPECT_NEAR(agreement.energy_direct_ratio, 1.0, 0.02) << slope.name;
        EXPECT_NEAR(agreement.energy_diffuse_ratio, 1.0, 0.02) << slope.name;
        EXPECT_NEAR(agreement.ground_light_difference, 0.0, 0.02) << slope.name;
        // The south misses the criterion of 0.85 in columns of 10 m: see validation/forest_light/README.md.
        EXPECT_GE(agreement.tree_light_correlation, south ? 0.80 : 0.85) << slope.name;
        EXPECT_NEAR(agreement.tree_light_bias, 0.0, 0.06) << slope.name;
        EXPECT_LE(agreement.tree_light_rmse, south ? 0.15 : 0.11) << slope.name;
    }
}

TEST(CompareLight, AgreesCloserInColumnsOfFiveMetres) {
    for (const MappedSlope& slope : prenovel().slopes) {
        const LightAgreement agreement = printed(
            slope, {.column_m = 5.0, .extinction = forest::effective_extinction_of_5m, .ground_points = 2});
        EXPECT_NEAR(agreement.ground_light_difference, 0.0, 0.005) << slope.name;
        EXPECT_GE(agreement.tree_light_correlation, 0.85) << slope.name;
        EXPECT_NEAR(agreement.tree_light_bias, 0.0, 0.03) << slope.name;
        EXPECT_LE(agreement.tree_light_rmse, 0.11) << slope.name;
    }
}

}  // namespace
}  // namespace coupling::validation::forest_cases::mapped_stand_test
