#include "forest/treatment/young.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/forest/small_forest.hpp"

namespace forest::young_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");
const SpeciesId fir = *table.find("abal");

TEST(Plant, SetsAsManyAsWereAskedFor) {
    Stand stand{square_of_forest(20), table.size(), {}, 2000};
    const std::uint64_t plants = plant(stand, {}, {.species = fir, .stems_pha = 1750.0}, 1, 0);
    EXPECT_EQ(plants, stand.saplings_standing());
    // 17.5 a patch: half a plant is decided by chance on each of 400.
    EXPECT_NEAR(static_cast<double>(plants), 7000.0, 4.0 * 0.5 * 20.0);
    EXPECT_EQ(stand.cohorts()[0].origin, Origin::planted);
    EXPECT_EQ(stand.cohorts()[0].height_m, 0.35);
}

TEST(PlantClusters, SetsTwentyFiveOnEverySecondPatchOfEverySecondRow) {
    Stand stand{square_of_forest(20), table.size(), {}, 2000};
    EXPECT_EQ(plant_clusters(stand, {}, {.species = fir}, 2), 100U * 25U);
    EXPECT_EQ(stand.cohorts().size(), 100U);
}

TEST(Plant, KeepsToItsArea) {
    Stand stand{square_of_forest(20), table.size(), {}, 2000};
    const config::Shape plot = rectangle({100.0, 100.0}, 40.0, 20.0, config::Angle::from_degrees(0.0));
    plant(stand, {{plot}, {}}, {.species = fir, .stems_pha = 2000.0}, 1, 0);
    EXPECT_EQ(stand.cohorts().size(), 8U);
}

TEST(Tend, CutsOthersWhereAFavouredSpeciesStands) {
    Stand stand{square_of_forest(2), table.size(), {}, 2000};
    const auto young = [](std::uint32_t patch, SpeciesId species, double height_m) {
        return Cohort{.patch = PatchId{patch}, .species = species, .stems = 20, .height_m = height_m};
    };
    stand.add_cohorts(std::vector<Cohort>{young(0, spruce, 1.0), young(0, fir, 0.8), young(0, spruce, 0.2),
                                          young(1, spruce, 1.0)});
    const std::vector<SpeciesId> favoured{fir};
    EXPECT_EQ(tend(stand, {}, {.favoured = favoured, .cut_share = 0.75}).stems, 15U);
    EXPECT_EQ(stand.cohorts()[0].stems, 5U);
    EXPECT_EQ(stand.cohorts()[1].stems, 20U);
    EXPECT_EQ(stand.cohorts()[2].stems, 20U) << "too small to press the fir";
    EXPECT_EQ(stand.cohorts()[3].stems, 20U) << "no fir there";
    EXPECT_EQ(stand.balance().saplings_out[index_of(Cause::felled)], 15U);
}

TEST(Fence, StandsOnItsAreaAndALongerOneStays) {
    Stand stand{square_of_forest(20), table.size(), {}, 2000};
    const config::Shape plot = rectangle({100.0, 100.0}, 40.0, 20.0, config::Angle::from_degrees(0.0));
    EXPECT_NEAR(fence(stand, {{plot}, {}}, 15), 0.08, 1e-12);
    const auto fenced = [&](int years) {
        return std::count_if(stand.patch_states().begin(), stand.patch_states().end(),
                             [&](const PatchState& state) { return state.fenced_years == years; });
    };
    EXPECT_EQ(fenced(15), 8);
    EXPECT_EQ(fenced(0), 392);
    EXPECT_NEAR(fence(stand, {}, 10), 3.92, 1e-12);
    EXPECT_EQ(fenced(15), 8);
    EXPECT_EQ(fenced(10), 392);
}

TEST(PatchesWithFewer, CountWhatHasEstablished) {
    Stand stand{square_of_forest(2), table.size(), {}, 2000};
    stand.add_cohorts(std::vector<Cohort>{
        {.patch = PatchId{0}, .species = spruce, .stems = 9, .height_m = 0.5},
        {.patch = PatchId{1}, .species = spruce, .stems = 10, .height_m = 0.5},
        {.patch = PatchId{2}, .species = spruce, .stems = 900, .height_m = 0.1},
    });
    const PatchGrid& grid = stand.grid();
    stand.add_trees(std::vector<Tree>{new_tree(table[spruce], spruce, grid.x_centre_m(PatchId{3}),
                                               grid.y_centre_m(PatchId{3}), 3.0, 3.0, 9.0)});
    EXPECT_EQ(young_trees_pha(stand), (std::vector{900.0, 1000.0, 0.0, 100.0}));
    EXPECT_EQ(patches_with_fewer(stand, {}, 1000.0), (std::vector{PatchId{0}, PatchId{2}, PatchId{3}}));
    EXPECT_EQ(plant_on(stand, std::vector{PatchId{2}}, {.species = spruce, .stems_pha = 500.0}, 1, 0), 5U);
}

}  // namespace
}  // namespace forest::young_test
