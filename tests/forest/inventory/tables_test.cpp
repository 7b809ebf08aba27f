#include "forest/inventory/tables.hpp"

#include <gtest/gtest.h>

#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::tables_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

Tree spruce_of(double dbh_cm, double height_m, std::uint32_t stems = 1) {
    Tree tree = new_tree(table[spruce], spruce, 5.0, 5.0, dbh_cm, height_m, 50.0);
    tree.stems = stems;
    return tree;
}

TEST(FiguresOf, AreThoseOfAHandfulOfTrees) {
    const std::vector<Tree> trees{spruce_of(30.0, 25.0), spruce_of(40.0, 30.0), spruce_of(3.0, 3.0, 8)};
    const StandFigures figures = figures_of(trees, table, 0.01);
    EXPECT_DOUBLE_EQ(figures.stems_pha, 1000.0);
    EXPECT_NEAR(figures.basal_area_m2pha, 100.0 * (0.070686 + 0.125664 + 8 * 0.000707), 0.01);
    EXPECT_NEAR(figures.mean_dbh_cm, std::sqrt((900.0 + 1600.0 + 8 * 9.0) / 10.0), 1e-9);
    EXPECT_DOUBLE_EQ(figures.dominant_height_m, 30.0) << "the thickest of 100 a hectare";
    EXPECT_DOUBLE_EQ(figures.stems_pha_by_class[0], 800.0);
    EXPECT_DOUBLE_EQ(figures.stems_pha_by_class[7], 100.0);
    EXPECT_DOUBLE_EQ(figures.stems_pha_by_class[10], 100.0);
}

TEST(FiguresOf, CountThickTreesApart) {
    const std::vector<Tree> trees{spruce_of(7.0, 8.0), spruce_of(11.9, 12.0), spruce_of(12.0, 12.0),
                                  spruce_of(6.9, 8.0)};
    const StandFigures figures = figures_of(trees, table, 0.01);
    EXPECT_DOUBLE_EQ(figures.from[0].stems_pha, 300.0);
    EXPECT_DOUBLE_EQ(figures.from[1].stems_pha, 100.0);
    EXPECT_DOUBLE_EQ(figures.from[1].basal_area_m2pha, 100.0 * basal_area_m2(12.0));
    EXPECT_DOUBLE_EQ(figures.from[1].volume_m3pha,
                     100.0 * stem_volume_m3(table[spruce].allometry, 12.0, 12.0));
    EXPECT_LT(figures.from[0].volume_m3pha, figures.volume_m3pha);
}

TEST(FiguresOf, AreNothingWithoutTrees) {
    const StandFigures figures = figures_of({}, table, 1.0);
    EXPECT_EQ(figures.mean_dbh_cm, 0.0);
    EXPECT_EQ(figures.dominant_height_m, 0.0);
}

TEST(FiguresOf, PutEveryStemIntoAClass) {
    const PatchGrid grid = square_of_forest(4);
    const Stand stand{grid, table.size(), any_trees(grid, table, 500, 8), 2000};
    const StandFigures figures = figures_of(stand.trees(), table, grid.area_ha());
    double in_classes = 0.0;
    for (const double stems : figures.stems_pha_by_class) {
        in_classes += stems;
    }
    EXPECT_NEAR(in_classes, figures.stems_pha, 1e-6);
    double by_species_m3 = 0.0;
    for (const StandFigures& of_one : figures_by_species(stand.trees(), table, grid.area_ha())) {
        by_species_m3 += of_one.volume_m3pha;
    }
    EXPECT_NEAR(by_species_m3, figures.volume_m3pha, 1e-6 * figures.volume_m3pha);
}

TEST(YearOf, CountsLossesByTheirCause) {
    std::vector<Tree> trees{spruce_of(30.0, 25.0), spruce_of(40.0, 30.0)};
    trees[1].id = TreeId{1};
    Stand stand{square_of_forest(1), table.size(), trees, 2000};
    stand.begin_year();
    stand.remove_trees(std::vector<Removal>{{TreeId{1}, Cause::rock}});
    const StandYear year = year_of(stand, table, 0.05);
    EXPECT_EQ(year.year, 2001);
    EXPECT_DOUBLE_EQ(year.volume_increment_m3pha, 5.0);
    EXPECT_DOUBLE_EQ(year.losses[index_of(Cause::rock)].stems_pha, 100.0);
    EXPECT_NEAR(year.losses[index_of(Cause::rock)].volume_m3pha,
                100.0 * stem_volume_m3(table[spruce].allometry, 40.0, 30.0), 1e-9);
    EXPECT_DOUBLE_EQ(year.losses[index_of(Cause::felled)].stems_pha, 0.0);
    const Loss& of_spruce = year.losses_by_species[index_of(spruce)][index_of(Cause::rock)];
    EXPECT_EQ(of_spruce.volume_m3pha, year.losses[index_of(Cause::rock)].volume_m3pha);
    EXPECT_EQ(year.losses_by_species[index_of(*table.find("fasy"))][index_of(Cause::rock)].stems_pha, 0.0);
}

TEST(YearOf, PutsDeadWoodIntoItsDecayClasses) {
    Stand stand{square_of_forest(1), table.size(), {}, 2000};
    std::vector<Snag> snags;
    for (const double density : density_of_decay_class) {
        snags.push_back({.species = spruce,
                         .dbh_cm = 30.0,
                         .tree_height_m = 25.0,
                         .height_m = 25.0,
                         .density_share = density,
                         .sound_kg = 430.0});
    }
    stand.add_snags(snags);
    const StandYear year = year_of(stand, table, 0.0);
    double sum_m3pha = 0.0;
    for (std::size_t i = 0; i < decay_class_count; ++i) {
        // A cubic metre of sound wood each, as far as decay has left it, on a hundredth of a hectare.
        EXPECT_NEAR(year.dead_wood_m3pha[i], 100.0 * volume_left(density_of_decay_class[i]), 1e-9) << i;
        sum_m3pha += year.dead_wood_m3pha[i];
    }
    EXPECT_NEAR(sum_m3pha, year.snags_m3pha + year.logs_m3pha, 1e-9);
}

}  // namespace
}  // namespace forest::tables_test
