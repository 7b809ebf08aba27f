#include "forest/treatment/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "forest/stand/allometry.hpp"
#include "forest/stand/self_thinning.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::selection_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

/// A hectare of spruce.
Stand hectare(Structure structure, double stems_pha, double mean_dbh_cm) {
    const PatchGrid grid = square_of_forest(10);
    StandRecord record;
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = spruce, .stems_pha = stems_pha, .mean_dbh_cm = mean_dbh_cm}};
    record.structure = structure;
    record.degree_days = 1200.0;
    return {grid, table.size(), trees_from_record(record, grid, table, 1, 0, 0), 2000};
}

std::vector<std::size_t> everyone(const Stand& stand) {
    std::vector<std::size_t> places(stand.trees().size());
    std::iota(places.begin(), places.end(), 0);
    return places;
}

double basal_area(const Stand& stand, const Picks& places) {
    double sum = 0.0;
    for (const std::size_t place : places) {
        sum += stand.trees()[place].stems * basal_area_m2(stand.trees()[place].dbh_cm);
    }
    return sum;
}

double volume(const Stand& stand, const Picks& places) {
    double sum = 0.0;
    for (const std::size_t place : places) {
        const Tree& tree = stand.trees()[place];
        sum += tree.stems * stem_volume_m3(table[tree.species].allometry, tree.dbh_cm, tree.height_m);
    }
    return sum;
}

TEST(ThinFromBelow, TakesTheThinnestUpToTheShare) {
    const Stand stand = hectare(Structure::even_aged, 900.0, 25.0);
    const Picks all = everyone(stand);
    const Picks picks = thin_from_below(stand, all, 0.25);
    EXPECT_NEAR(basal_area(stand, picks) / basal_area(stand, all), 0.25, 0.005);
    const std::set<std::size_t> felled{picks.begin(), picks.end()};
    double thickest_felled_cm = 0.0;
    double thinnest_left_cm = 1000.0;
    for (const std::size_t place : all) {
        const double dbh_cm = stand.trees()[place].dbh_cm;
        (felled.contains(place) ? thickest_felled_cm : thinnest_left_cm) =
            felled.contains(place) ? std::max(thickest_felled_cm, dbh_cm)
                                   : std::min(thinnest_left_cm, dbh_cm);
    }
    EXPECT_LE(thickest_felled_cm, thinnest_left_cm);
    EXPECT_TRUE(thin_from_below(stand, all, 0.0).empty());
}

TEST(ThinToStems, TakesTheThinnestThatMayGoDownToTheStems) {
    const Stand stand = hectare(Structure::even_aged, 900.0, 25.0);
    const Picks all = everyone(stand);
    const Picks picks = thin_to_stems(stand, all, all, 1.0, 600.0);
    EXPECT_EQ(all.size() - picks.size(), 600U);
    double thickest_felled_cm = 0.0;
    for (const std::size_t place : picks) {
        thickest_felled_cm = std::max(thickest_felled_cm, stand.trees()[place].dbh_cm);
    }
    EXPECT_EQ(static_cast<std::size_t>(std::count_if(
                  all.begin(), all.end(),
                  [&](std::size_t place) { return stand.trees()[place].dbh_cm < thickest_felled_cm; })),
              picks.size() - 1);
    EXPECT_TRUE(thin_to_stems(stand, all, all, 1.0, 900.0).empty());
    const Picks may_go{all.begin(), all.begin() + 100};
    EXPECT_EQ(thin_to_stems(stand, all, may_go, 1.0, 600.0).size(), 100U) << "all that may go";
}

TEST(ThinToDensity, LeavesTheTargetDensity) {
    Stand stand = hectare(Structure::even_aged, 1100.0, 26.0);
    const ThinningWindows windows{stand.grid()};
    const Picks picks = thin_to_density(stand, table, everyone(stand), 1.0, 0.65);
    std::vector<Removal> removals;
    for (const std::size_t place : picks) {
        removals.push_back({stand.trees()[place].id, Cause::felled});
    }
    stand.remove_trees(removals);
    EXPECT_TRUE(thin_to_density(stand, table, everyone(stand), 1.0, 0.65).empty());
    const std::vector<double> densities = relative_densities(stand, table, windows);
    EXPECT_NEAR(
        std::accumulate(densities.begin(), densities.end(), 0.0) / static_cast<double>(densities.size()),
        0.65, 0.05);
}

TEST(ThinForCropTrees, FreesThickTreesWithinItsVolume) {
    const Stand stand = hectare(Structure::even_aged, 1200.0, 18.0);
    const Picks all = everyone(stand);
    const Picks picks = thin_for_crop_trees(stand, table, all, 1.0, {});
    EXPECT_GT(picks.size(), 50U);
    EXPECT_LE(volume(stand, picks), 0.2 * volume(stand, all));
    EXPECT_EQ((std::set<std::size_t>{picks.begin(), picks.end()}).size(), picks.size());
    const double mean_felled = std::sqrt(basal_area(stand, picks) / static_cast<double>(picks.size()));
    const double mean_all = std::sqrt(basal_area(stand, all) / static_cast<double>(all.size()));
    EXPECT_GT(mean_felled, 0.9 * mean_all) << "from above, not from below";
}

TEST(TargetDiameter, SparesSeedTreesAndThinOnes) {
    Stand stand = hectare(Structure::even_aged, 400.0, 40.0);
    const TreeId mother = stand.trees()[0].id;
    stand.set_flags(mother, {.seed_tree = true});
    const Picks picks = target_diameter(stand, everyone(stand), 35.0);
    for (const std::size_t place : picks) {
        EXPECT_GE(stand.trees()[place].dbh_cm, 35.0);
        EXPECT_NE(stand.trees()[place].id, mother);
    }
    EXPECT_GT(picks.size(), 200U);
}

TEST(StemsOfSelectionForest, FallByQAndAddUpToTheBasalArea) {
    const SelectionForest aim;
    const std::vector<double> stems = stems_of_selection_forest(aim);
    ASSERT_EQ(stems.size(), 10U) << "10-15 ... 55-60 cm";
    double basal = 0.0;
    for (std::size_t c = 0; c < stems.size(); ++c) {
        basal += stems[c] * basal_area_m2(12.5 + 5.0 * static_cast<double>(c));
        if (c > 0) {
            EXPECT_NEAR(stems[c - 1] / stems[c], aim.q, 1e-9);
        }
    }
    EXPECT_NEAR(basal, aim.basal_area_m2pha, 1e-9);
}

TEST(SingleTreeSelection, TakesTheExcessOfEachClassWithinItsVolume) {
    const Stand stand = hectare(Structure::plenter, 700.0, 30.0);
    const Picks all = everyone(stand);
    SelectionForest aim{.basal_area_m2pha = 30.0};
    const Picks limited = single_tree_selection(stand, table, all, 1.0, aim, 1, 0);
    EXPECT_LE(volume(stand, limited), 0.25 * volume(stand, all));
    EXPECT_FALSE(limited.empty());

    aim.most_volume_share = 1.0;
    const Picks free = single_tree_selection(stand, table, all, 1.0, aim, 1, 0);
    const std::set<std::size_t> felled{free.begin(), free.end()};
    std::vector<double> left(20, 0.0);
    for (const std::size_t place : all) {
        const double dbh_cm = stand.trees()[place].dbh_cm;
        if (!felled.contains(place) && dbh_cm >= 10.0) {
            left[static_cast<std::size_t>((dbh_cm - 10.0) / 5.0)] += 1.0;
        }
    }
    const std::vector<double> wanted = stems_of_selection_forest(aim);
    for (std::size_t c = 0; c < left.size(); ++c) {
        EXPECT_LE(left[c], (c < wanted.size() ? wanted[c] : 0.0) + 1.0) << c;
    }
}

TEST(Loosen, TakesTreesOfAnySizeUpToTheShare) {
    const Stand stand = hectare(Structure::even_aged, 500.0, 35.0);
    const Picks all = everyone(stand);
    const Picks picks = loosen(stand, all, 0.35, 1, 0);
    EXPECT_NEAR(basal_area(stand, picks) / basal_area(stand, all), 0.35, 0.01);
    const double share = static_cast<double>(picks.size()) / static_cast<double>(all.size());
    EXPECT_NEAR(share, 0.35, 0.06) << "neither the thick nor the thin first";
    EXPECT_NE(picks, loosen(stand, all, 0.35, 2, 0));
}

TEST(ThinVolumeFromBelow, TakesMoreStemsThanTheSameShareOfBasalArea) {
    const Stand stand = hectare(Structure::even_aged, 900.0, 25.0);
    const Picks all = everyone(stand);
    const auto volume_m3 = [&](const Picks& places) {
        double sum = 0.0;
        for (const std::size_t place : places) {
            const Tree& tree = stand.trees()[place];
            sum += stem_volume_m3(table[spruce].allometry, tree.dbh_cm, tree.height_m);
        }
        return sum;
    };
    const Picks picks = thin_volume_from_below(stand, table, all, 0.25);
    EXPECT_NEAR(volume_m3(picks) / volume_m3(all), 0.25, 0.005);
    EXPECT_GT(picks.size(), thin_from_below(stand, all, 0.25).size());
}

TEST(RelativeDensity, IsOneOnTheLineOfMostStems) {
    const Stand stand = hectare(Structure::even_aged, 900.0, 25.0);
    double stems = 0.0;
    double squares_cm2 = 0.0;
    for (const Tree& tree : stand.trees()) {
        stems += tree.dbh_cm >= counted_dbh_cm ? 1.0 : 0.0;
        squares_cm2 += tree.dbh_cm >= counted_dbh_cm ? tree.dbh_cm * tree.dbh_cm : 0.0;
    }
    const double area_ha = stems / most_stems_pha(table[spruce].mortality, std::sqrt(squares_cm2 / stems));
    EXPECT_NEAR(relative_density(stand, table, everyone(stand), area_ha), 1.0, 1e-9);
    EXPECT_EQ(relative_density(stand, table, {}, 1.0), 0.0);
}

}  // namespace
}  // namespace forest::selection_test
