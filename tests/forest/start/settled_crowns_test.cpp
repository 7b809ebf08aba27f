#include "forest/start/settled_crowns.hpp"

#include <gtest/gtest.h>

#include "forest/stand/allometry.hpp"
#include "forest/stand/crown.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::settled_crowns_test {
namespace {

double leaf_area_index(const Stand& stand) {
    double leaves_m2 = 0.0;
    for (const Tree& tree : stand.trees()) {
        leaves_m2 += tree.stems * tree.crown.leaf_area_m2;
    }
    return leaves_m2 / stand.grid().area_m2();
}

/// A closed stand of spruce as an inventory describes it.
std::vector<Tree> recorded(const SmallForest& forest, double stems_pha) {
    StandRecord record;
    for (std::uint32_t i = 0; i < forest.grid.size(); ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = *forest.species.find("piab"),
                       .stems_pha = stems_pha,
                       .mean_dbh_cm = 28.0,
                       .mean_height_m = 24.0,
                       .age_years = 80.0}};
    record.degree_days = 1300.0;
    return trees_from_record(record, forest.grid, forest.species, 1, 0, 0);
}

TEST(SettleCrowns, LeavesALoneTreeItsUsualCrown) {
    const SpeciesTable table = SpeciesTable::shipped();
    const SpeciesId spruce = *table.find("piab");
    std::vector<Tree> trees{new_tree(table[spruce], spruce, 5.0, 5.0, 30.0, 22.0, 80.0)};
    const double usual_m = trees[0].crown.base_m;
    settle_crowns(trees, table, 1e6);
    EXPECT_DOUBLE_EQ(trees[0].crown.base_m, usual_m);
}

TEST(SettleCrowns, RaisesThemInADenseStand) {
    const SmallForest forest{square_of_forest(5)};
    double usual_m2 = 0.0;
    double settled_m2 = 0.0;
    for (const Tree& tree : recorded(forest, 900.0)) {
        const Species& kind = forest.species[tree.species];
        usual_m2 += starting_crown(kind, tree.dbh_cm, tree.height_m).leaf_area_m2;
        settled_m2 += tree.crown.leaf_area_m2;
        EXPECT_NEAR(tree.above_ground_kg,
                    part_masses(kind.allometry, tree.dbh_cm, tree.height_m, tree.crown.completeness)
                        .above_ground_kg(),
                    1e-9);
    }
    EXPECT_LT(settled_m2, 0.97 * usual_m2);
}

TEST(RecordedStand, KeepsItsLeavesInTheFirstYears) {
    // Stands that were put in with crowns of usual length lost a fifth to a quarter of their leaves in 15
    // years.
    for (const double stems_pha : {400.0, 900.0}) {
        const SmallForest forest{square_of_forest(5, 0.0)};
        Stand stand{forest.grid, forest.species.size(), recorded(forest, stems_pha), 2000};
        const double at_start = leaf_area_index(stand);
        for (int year = 0; year < 15; ++year) {
            static_cast<void>(forest.grow(stand));
        }
        EXPECT_GT(leaf_area_index(stand), 0.85 * at_start) << stems_pha;
        EXPECT_LT(leaf_area_index(stand), 1.3 * at_start) << stems_pha;
    }
}

}  // namespace
}  // namespace forest::settled_crowns_test
