#include "forest/light/light_profile.hpp"

#include <gtest/gtest.h>

#include "forest/light/layer_light.hpp"
#include "forest/light/stand_light.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::light_profile_test {
namespace {

/// A young spruce stand whose trees are all in the two lowest layers of the light model.
struct Thicket {
    Thicket() : forest{square_of_forest(4, 0.0)}, stand{forest.grid, forest.species.size(), trees(), 2000} {
        const std::vector<LightTree> seen = light_trees_of(stand, forest.species);
        const Canopy canopy{forest.site.light().ground(), seen};
        const LightYear year = light_year_of(forest.site, forest.species, {forest.weather, 350.0, false});
        field = compute_light(forest.site.light(), canopy, year, seen);
        light = light_in_stand(stand, forest.species, forest.site.light(), canopy, field);
        profiles.emplace(stand, forest.species, forest.site.light(), canopy, field);
    }

    [[nodiscard]] std::vector<Tree> trees() const {
        std::vector<Tree> list;
        const SpeciesId spruce = *forest.species.find("piab");
        for (std::uint64_t i = 0; i < 320; ++i) {
            const double dbh_cm = i % 2 == 0 ? 12.0 : 7.0;
            const double height_m = i % 2 == 0 ? 9.0 : 5.5;
            const auto x_m = 1.0 + 2.0 * static_cast<double>(i % 20);
            const auto y_m = 1.0 + 2.5 * static_cast<double>(i / 20);
            list.push_back(new_tree(forest.species[spruce], spruce, x_m, y_m, dbh_cm, height_m, 30.0));
            list.back().id = TreeId{i};
        }
        return list;
    }

    SmallForest forest;
    Stand stand;
    LightField field;
    StandLight light;
    std::optional<LightProfiles> profiles;
};

TEST(LightProfiles, RiseWithHeight) {
    const Thicket thicket;
    for (std::uint32_t patch = 0; patch < 16; ++patch) {
        double below = 0.0;
        for (double height_m = 0.0; height_m < 15.0; height_m += 0.5) {
            const double here = thicket.profiles->at(PatchId{patch}, height_m);
            EXPECT_GE(here, below - 1e-6);
            EXPECT_LE(here, 1.0);
            below = here;
        }
        EXPECT_GT(below, 0.9);
    }
}

TEST(LightProfiles, TellTallTreesFromShortOnesOfTheSameLayer) {
    const Thicket thicket;
    for (std::size_t i = 0; i + 1 < 320; i += 2) {
        EXPECT_GT(thicket.light.ratios[i], 1.3 * thicket.light.ratios[i + 1]) << i;
    }
}

TEST(LightProfiles, KnowWhereALeafStarves) {
    const Thicket thicket;
    const double shaded_m = thicket.profiles->shaded_below_m(PatchId{5}, 0.2);
    EXPECT_GT(shaded_m, 0.0);
    EXPECT_LT(shaded_m, 9.0);
    EXPECT_NEAR(thicket.profiles->at(PatchId{5}, shaded_m), 0.2, 0.01);
    EXPECT_EQ(thicket.profiles->shaded_below_m(PatchId{5}, 0.0), 0.0);
}

TEST(LayerLight, AbsorbsWhatLeavesLetThroughToNobody) {
    const SpeciesTable species = SpeciesTable::shipped();
    const std::vector<Tree> trees = any_trees(square_of_forest(5), species, 200, 3);
    double absorbed_m2 = 0.0;
    for (const LayerLight& one : layer_light(trees, species, 2500.0)) {
        EXPECT_GE(one.light_ratio, 0.0);
        EXPECT_LE(one.light_ratio, 1.0);
        EXPECT_GE(one.absorbed_m2, 0.0);
        absorbed_m2 += one.absorbed_m2;
    }
    EXPECT_GT(absorbed_m2, 0.0);
}

TEST(CrownShareBelow, IsAVolume) {
    EXPECT_DOUBLE_EQ(crown_share_below(CrownShape::paraboloid, 10.0, 20.0, 15.0), 0.75);
    EXPECT_DOUBLE_EQ(crown_share_below(CrownShape::ellipsoid, 10.0, 20.0, 15.0), 0.5);
    EXPECT_DOUBLE_EQ(crown_share_below(CrownShape::ellipsoid, 10.0, 20.0, 9.0), 0.0);
    EXPECT_DOUBLE_EQ(crown_share_below(CrownShape::paraboloid, 10.0, 20.0, 21.0), 1.0);
}

}  // namespace
}  // namespace forest::light_profile_test
