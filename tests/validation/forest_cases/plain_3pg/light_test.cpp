#include "validation/engine/forest_cases/plain_3pg/light.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/validation/forest_cases/plain_3pg/reference.hpp"

namespace coupling::validation::forest_cases::plain_3pg::light_test {
namespace {

TEST(CrownBody, IsThatOfTheKnownSolids) {
    // A crown as wide as it is long: a sphere of 4 m; Thomsen's approximation is exact for it.
    EXPECT_NEAR(crown_body(CrownForm::ellipsoid, 4.0, 4.0).volume_m3, 4.0 / 3.0 * M_PI * 8.0, 1e-9);
    EXPECT_NEAR(crown_body(CrownForm::ellipsoid, 4.0, 4.0).surface_m2, 4.0 * M_PI * 4.0, 1e-9);
    EXPECT_NEAR(crown_body(CrownForm::half_ellipsoid, 4.0, 2.0).volume_m3, 2.0 / 3.0 * M_PI * 8.0, 1e-9);
    EXPECT_NEAR(crown_body(CrownForm::half_ellipsoid, 4.0, 2.0).surface_m2, 3.0 * M_PI * 4.0, 1e-9);
    EXPECT_NEAR(crown_body(CrownForm::cone, 6.0, 4.0).surface_m2, M_PI * 9.0 + M_PI * 3.0 * 5.0, 1e-9);
    EXPECT_NEAR(crown_body(CrownForm::cone, 6.0, 4.0).volume_m3, M_PI * 9.0 * 4.0 / 3.0, 1e-9);
    EXPECT_DOUBLE_EQ(crown_body(CrownForm::box, 2.0, 3.0).surface_m2, 32.0);
    EXPECT_DOUBLE_EQ(crown_body(CrownForm::box, 2.0, 3.0).volume_m3, 12.0);
}

TEST(Layers, JoinCrownsThatOverlap) {
    using Layers = std::vector<int>;
    EXPECT_EQ(layers_of(std::vector{10.0}, std::vector{20.0}), Layers{1});
    EXPECT_EQ(layers_of(std::vector{15.0, 2.0}, std::vector{30.0, 10.0}), (Layers{1, 2}));
    EXPECT_EQ(layers_of(std::vector{15.0, 12.0}, std::vector{30.0, 20.0}), (Layers{1, 1}));
    // The second reaches into the first and the third into the second.
    EXPECT_EQ(layers_of(std::vector{20.0, 12.0, 5.0}, std::vector{30.0, 22.0, 14.0}), (Layers{1, 1, 1}));
    EXPECT_EQ(layers_of(std::vector{1.0, 20.0, 8.0}, std::vector{5.0, 30.0, 15.0}), (Layers{3, 1, 2}));
}

TEST(NoonAngle, IsThatOfR3PgWithTheSeasonsExchanged) {
    const config::Angle north = config::Angle::from_degrees(47.57);
    EXPECT_NEAR(noon_angle_deg(north, 6), 47.57 + 23.4, 0.3);
    EXPECT_NEAR(noon_angle_deg(north, 12), 47.57 - 23.4, 0.3);
}

/// A stand of the demonstration's species, its sizes computed, one year in leaf.
struct LeafyStand {
    Inputs inputs;
    Stand stand;
    ClimateMonth june;
};

LeafyStand leafy(const std::vector<std::string>& species) {
    LeafyStand result{demonstration(species), {}, {}};
    const std::vector<Row> rows = run(result.inputs, mixture_settings);
    for (const Row& row : rows) {
        if (row.when.year == 2003 && row.when.month == 6) {
            result.stand.species.push_back(row.state);
            result.june = row.climate;
        }
    }
    return result;
}

TEST(AbsorbByLayers, TakesNoMoreThanThereIsAndSharesItAll) {
    LeafyStand mixed = leafy({"Fagus sylvatica", "Pinus sylvestris"});
    absorb_by_layers(mixed.stand, mixed.inputs, mixed.june);
    double shares = 0.0;
    double absorbed = 0.0;
    for (const SpeciesMonth& species : mixed.stand.species) {
        EXPECT_GT(species.canopy.absorbed_mjpm2, 0.0);
        EXPECT_GT(species.canopy.vertical, 0.0);
        shares += species.canopy.vertical;
        absorbed += species.canopy.absorbed_share;
    }
    EXPECT_NEAR(shares, 1.0, 1e-12) << "both in one layer";
    EXPECT_LT(absorbed, 1.3) << "the factor for gaps may exceed 1";
}

TEST(AbsorbByLayers, GivesTheHigherLayerFirst) {
    LeafyStand mixed = leafy({"Fagus sylvatica", "Pinus sylvestris"});
    Sizes& beech = mixed.stand.species[0].sizes;
    beech.height_m =
        0.5 * (mixed.stand.species[1].sizes.height_m - mixed.stand.species[1].sizes.crown_length_m);
    beech.crown_length_m = 0.5 * beech.height_m;
    absorb_by_layers(mixed.stand, mixed.inputs, mixed.june);
    const Canopy& below = mixed.stand.species[0].canopy;
    const Canopy& above = mixed.stand.species[1].canopy;
    EXPECT_EQ(below.layer, 2);
    EXPECT_EQ(above.layer, 1);
    EXPECT_DOUBLE_EQ(below.vertical, 1.0);
    EXPECT_DOUBLE_EQ(below.lai_above, above.lai);
    const double k = mixed.inputs.parameters[1].extinction;
    const double light = mixed.june.radiation_mjpm2 * 30.0;
    EXPECT_NEAR(above.absorbed_mjpm2, light * (1.0 - std::exp(-k * above.lai)) * above.horizontal, 1e-8);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::plain_3pg::light_test
