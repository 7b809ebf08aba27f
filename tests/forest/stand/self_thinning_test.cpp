#include "forest/stand/self_thinning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::self_thinning_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();

TEST(MostStems, AreThoseOfTheFrenchInventoryAtTheMeanDiameterOfItsPlots) {
    EXPECT_NEAR(most_stems_pha(table[*table.find("abal")].mortality, 25.0), 1310.0, 5.0);
    struct Line {
        const char* species;
        double mean_dbh_cm;
        double intercept;
        double slope;
    };
    // ln N = intercept + slope ln D in matreex; mean diameters: Charru et al. 2012.
    for (const Line& line : {Line{"piab", 29.2, 12.5115, -1.65234}, Line{"fasy", 27.3, 14.4432, -2.30434},
                             Line{"pisy", 22.2, 13.3341, -1.98621}, Line{"qupe", 23.0, 13.4947, -2.10965}}) {
        const double stems_pha = std::exp(line.intercept + line.slope * std::log(line.mean_dbh_cm));
        EXPECT_NEAR(most_stems_pha(table[*table.find(line.species)].mortality, line.mean_dbh_cm), stems_pha,
                    0.002 * stems_pha)
            << line.species;
    }
}

TEST(MostStems, FallWithDiameterAsOnUnthinnedLongTermPlots) {
    // Pretzsch & Biber 2005 (Forest Science 51:304), Reineke 1933.
    const auto slope = [](const char* species) {
        const Mortality& law = table[*table.find(species)].mortality;
        return std::log(most_stems_pha(law, 50.0) / most_stems_pha(law, 25.0)) / std::log(2.0);
    };
    EXPECT_NEAR(slope("fasy"), -1.789, 1e-9);
    EXPECT_NEAR(slope("piab"), -1.664, 1e-9);
    EXPECT_NEAR(slope("pisy"), -1.593, 1e-9);
    EXPECT_NEAR(slope("qupe"), -1.424, 1e-9);
    for (const char* other : {"acps", "frex", "bepe", "soau"}) {
        EXPECT_NEAR(slope(other), -1.605, 1e-9) << other;
    }
}

TEST(ThinningWindows, CoverFiftyMetres) {
    const ThinningWindows windows{square_of_forest(10)};
    ASSERT_EQ(windows.size(), 4U);
    EXPECT_DOUBLE_EQ(windows.area_ha(0), 0.25);
}

TEST(ThinningWindows, JoinMarginsToTheirNeighbours) {
    // 12 x 12 patches: margins of two patches belong to the windows beside them.
    const ThinningWindows windows{square_of_forest(12)};
    double area_ha = 0.0;
    for (std::size_t w = 0; w < windows.size(); ++w) {
        area_ha += windows.area_ha(w);
    }
    EXPECT_NEAR(area_ha, 1.44, 1e-12);
    EXPECT_LE(windows.size(), 5U);
}

TEST(ThinningWindows, AreOneForASinglePatch) {
    EXPECT_EQ(ThinningWindows{square_of_forest(1)}.size(), 1U);
}

TEST(WindowBasalAreas, CountStemsFromSevenCentimetres) {
    const PatchGrid grid = square_of_forest(10);
    std::vector<Tree> trees = any_trees(grid, table, 3, 3);
    const auto put = [&](std::size_t i, double x_m, double y_m, double dbh_cm, std::uint32_t stems) {
        trees[i].x_m = x_m;
        trees[i].y_m = y_m;
        trees[i].patch = *grid.at(x_m, y_m);
        trees[i].dbh_cm = dbh_cm;
        trees[i].stems = stems;
    };
    put(0, 5.0, 5.0, 100.0, 1);
    put(1, 45.0, 45.0, 20.0, 10);
    put(2, 15.0, 15.0, 6.9, 50);
    const Stand stand{grid, table.size(), trees, 2000};
    const ThinningWindows windows{grid};
    const std::vector<double> areas_m2pha = window_basal_areas_m2pha(stand, windows);
    const std::size_t window = windows.window_of(trees[0].patch);
    ASSERT_EQ(windows.window_of(trees[1].patch), window);
    EXPECT_NEAR(areas_m2pha[window], (0.7853981634 + 10 * 0.0314159265) / 0.25, 1e-6);
    EXPECT_EQ(areas_m2pha[windows.window_of(*grid.at(95.0, 95.0))], 0.0);
}

TEST(LargerBasalAreas, AreThoseOfTheThickerTreesInTheWindow) {
    const PatchGrid grid = square_of_forest(10);
    const Stand stand{grid, table.size(), any_trees(grid, table, 2000, 5), 2000};
    const ThinningWindows windows{grid};
    const std::vector<double> larger_m2pha = larger_basal_areas_m2pha(stand, windows);
    const std::span<const Tree> trees = stand.trees();
    ASSERT_EQ(larger_m2pha.size(), trees.size());
    for (std::size_t i = 0; i < trees.size(); i += 50) {
        const std::size_t window = windows.window_of(trees[i].patch);
        double sum_m2 = 0.0;
        for (const Tree& other : trees) {
            if (windows.window_of(other.patch) == window && other.dbh_cm > trees[i].dbh_cm &&
                other.dbh_cm >= counted_dbh_cm) {
                sum_m2 += other.stems * basal_area_m2(other.dbh_cm);
            }
        }
        EXPECT_NEAR(larger_m2pha[i], sum_m2 / windows.area_ha(window), 1e-9);
    }
}

TEST(LargerBasalAreas, OfTreesOfOneDiameterLeaveOutTheirLike) {
    const PatchGrid grid = square_of_forest(5);
    std::vector<Tree> trees = any_trees(grid, table, 20, 3);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        trees[i].dbh_cm = i < 15 ? 30.0 : 50.0;
    }
    const Stand stand{grid, table.size(), trees, 2000};
    const std::vector<double> larger_m2pha = larger_basal_areas_m2pha(stand, ThinningWindows{grid});
    for (std::size_t i = 0; i < trees.size(); ++i) {
        EXPECT_EQ(larger_m2pha[i] > 0.0, i < 15) << i;
    }
}

TEST(SelfThinning, LeavesNoWindowAboveOneAndNoneFarBelow) {
    const PatchGrid grid = square_of_forest(10);
    Stand stand{grid, table.size(), any_trees(grid, table, 4000, 3), 2000};
    const ThinningWindows windows{grid};
    stand.remove_trees(self_thinning(stand, table, windows, 1, 0));
    for (const double density : relative_densities(stand, table, windows)) {
        EXPECT_LE(density, 1.0 + 1e-9);
        EXPECT_GT(density, 0.8) << "a single thick tree at most below the line";
    }
    EXPECT_EQ(stand.total_balance().all_stems_out() + stand.stems_standing(), stand.stems_at_start());
}

TEST(SelfThinning, TakesTheSlowestFirst) {
    const PatchGrid grid = square_of_forest(5);
    std::vector<Tree> trees = any_trees(grid, table, 1500, 4);
    for (Tree& tree : trees) {
        tree.increments_cm[0] = number_of(tree.id) % 2 == 0 ? 0.4 : 0.02;
        tree.dbh_cm = 30.0;
        tree.stems = 1;
        tree.species = *table.find("piab");
    }
    Stand stand{grid, table.size(), trees, 2000};
    stand.remove_trees(self_thinning(stand, table, ThinningWindows{grid}, 1, 0));
    for (const Tree& tree : stand.trees()) {
        EXPECT_DOUBLE_EQ(tree.increments_cm[0], 0.4);
    }
}

TEST(SelfThinning, TakesNobodyFromAnOpenStand) {
    const PatchGrid grid = square_of_forest(5);
    const Stand stand{grid, table.size(), any_trees(grid, table, 10, 4), 2000};
    EXPECT_TRUE(self_thinning(stand, table, ThinningWindows{grid}, 1, 0).empty());
}

}  // namespace
}  // namespace forest::self_thinning_test
