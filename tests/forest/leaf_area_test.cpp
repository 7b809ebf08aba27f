#include <gtest/gtest.h>

#include "forest/inventory/tables.hpp"
#include "forest/start/settled_crowns.hpp"
#include "forest/start/starting_stand.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::leaf_area_test {
namespace {

/// Leaf area index of a closed stand of one species and diameter, crowns settled in its own shade.
double closed_stand(const char* code, double dbh_cm, double basal_area_m2pha) {
    static const SmallForest forest{square_of_forest(5, 0.0)};
    const SpeciesId id = *forest.species.find(code);
    const double area_m2 = forest.grid.area_m2();
    const auto count =
        static_cast<std::size_t>(basal_area_m2pha * area_m2 / 10'000.0 / (7.854e-5 * dbh_cm * dbh_cm));
    std::vector<Tree> trees;
    for (std::size_t i = 0; i < count; ++i) {
        trees.push_back(new_tree(forest.species[id], id, 25.0, -25.0, dbh_cm, 0.9 * dbh_cm, 90.0));
        trees.back().id = TreeId{i};
    }
    settle_crowns(trees, forest.species, area_m2);
    return figures_of(trees, forest.species, area_m2 / 10'000.0).leaf_area_index;
}

TEST(LeafArea, OfClosedStandsIsThatOfTheLiterature) {
    // Closed beech 5 to 7, fir and spruce 6 to 8.
    for (const double dbh_cm : {25.0, 35.0}) {
        EXPECT_GT(closed_stand("fasy", dbh_cm, 33.0), 5.0) << dbh_cm;
        EXPECT_LT(closed_stand("fasy", dbh_cm, 33.0), 7.0) << dbh_cm;
        for (const char* code : {"piab", "abal"}) {
            // As in yield tables, thicker stands hold more basal area.
            const double basal_area_m2pha = dbh_cm < 30.0 ? 57.0 : 60.0;
            EXPECT_GT(closed_stand(code, dbh_cm, basal_area_m2pha), 6.0) << code << dbh_cm;
            EXPECT_LT(closed_stand(code, dbh_cm, basal_area_m2pha), 8.0) << code << dbh_cm;
        }
    }
}

}  // namespace
}  // namespace forest::leaf_area_test
