#include "coupling/validation/forest_cases/mapped_stand.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace coupling::validation::forest_cases::mapped_stand_test {
namespace {

config::Table table(const std::string& name) {
    std::ifstream in{std::string{BANNWALD_SOURCE_DIR} + "/validation/forest_light/" + name};
    return config::Table::read(in, name);
}

const MappedStand& prenovel() {
    static const MappedStand stand =
        mapped_stand(table("trees.csv"), table("ground.csv"), table("leaves.csv"), table("radiation.csv"),
                     table("slopes.csv"));
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

TEST(MappedStand, NamesASpeciesWithoutLeaves) {
    std::istringstream leaves{
        "species,crown,foliage_a,foliage_b,sla_m2_per_kg\nAbies alba,paraboloid,0.065,1.56,5\n"};
    EXPECT_THROW(
        mapped_stand(table("trees.csv"), table("ground.csv"), config::Table::read(leaves, "leaves.csv"),
                     table("radiation.csv"), table("slopes.csv")),
        config::InputError);
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
