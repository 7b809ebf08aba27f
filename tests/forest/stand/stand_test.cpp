#include "forest/stand/stand.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/forest/small_forest.hpp"

namespace forest::stand_test {
namespace {

Stand stand_of(std::vector<Tree> trees, int side = 2) {
    return {square_of_forest(side), 2, std::move(trees), 2000};
}

Tree tree_at(std::uint64_t id, double x_m, double y_m, std::uint32_t stems = 1) {
    Tree tree;
    tree.id = TreeId{id};
    tree.x_m = x_m;
    tree.y_m = y_m;
    tree.stems = stems;
    tree.dbh_cm = 20.0;
    tree.height_m = 15.0;
    tree.above_ground_kg = 100.0;
    return tree;
}

TEST(Stand, KeepsTreesInTheOrderOfTheirIds) {
    const Stand stand = stand_of({tree_at(7, 1, 1), tree_at(2, 15, 1), tree_at(5, 1, 15)});
    ASSERT_EQ(stand.trees().size(), 3U);
    EXPECT_EQ(number_of(stand.trees()[0].id), 2U);
    EXPECT_EQ(number_of(stand.trees()[2].id), 7U);
    EXPECT_EQ(stand.find(TreeId{5}), 1U);
    EXPECT_FALSE(stand.find(TreeId{3}));
}

TEST(Stand, KnowsThePatchUnderATree) {
    // Patches count from the north-west, the y axis from the south.
    const Stand stand = stand_of({tree_at(1, 1, 1), tree_at(2, 15, 15)});
    EXPECT_EQ(index_of(stand.trees()[0].patch), 2U);
    EXPECT_EQ(index_of(stand.trees()[1].patch), 1U);
}

TEST(Stand, GivesNoIdTwice) {
    Stand stand = stand_of({tree_at(7, 1, 1)});
    stand.remove_trees(std::vector<Removal>{{TreeId{7}, Cause::felled}});
    stand.add_trees(std::vector<Tree>{tree_at(7, 2, 2)});
    EXPECT_EQ(number_of(stand.trees()[0].id), 8U);
}

TEST(Stand, CountsEachRemovalUnderItsCause) {
    Stand stand = stand_of({tree_at(1, 1, 1), tree_at(2, 2, 2, 10), tree_at(3, 3, 3)});
    stand.begin_year();
    stand.remove_trees(std::vector<Removal>{
        {TreeId{1}, Cause::rock}, {TreeId{2}, Cause::stress, 4}, {TreeId{1}, Cause::wind}});
    EXPECT_EQ(stand.balance().stems_out[index_of(Cause::rock)], 1U);
    EXPECT_EQ(stand.balance().stems_out[index_of(Cause::stress)], 4U);
    EXPECT_EQ(stand.balance().stems_out[index_of(Cause::wind)], 0U) << "dead already";
    EXPECT_DOUBLE_EQ(stand.balance().all_lost_kg(), 500.0);
    EXPECT_EQ(stand.stems_standing(), 7U);
    ASSERT_EQ(stand.deaths().size(), 2U);
    EXPECT_EQ(stand.deaths()[1].tree.stems, 4U);
}

TEST(Stand, TakesNoMoreStemsThanStand) {
    Stand stand = stand_of({tree_at(2, 2, 2, 3)});
    stand.remove_trees(std::vector<Removal>{{TreeId{2}, Cause::stress, 2}, {TreeId{2}, Cause::felled, 2}});
    EXPECT_EQ(stand.balance().all_stems_out(), 3U);
    EXPECT_TRUE(stand.trees().empty());
}

TEST(Stand, BeginsANewPageEachYearAndForgetsNothing) {
    Stand stand = stand_of({tree_at(1, 1, 1), tree_at(2, 2, 2)});
    stand.begin_year();
    stand.remove_trees(std::vector<Removal>{{TreeId{1}, Cause::beetle}});
    stand.begin_year();
    EXPECT_EQ(stand.year(), 2002);
    EXPECT_EQ(stand.balance().all_stems_out(), 0U);
    EXPECT_TRUE(stand.deaths().empty());
    EXPECT_EQ(stand.total_balance().all_stems_out(), 1U);
    EXPECT_EQ(stand.stems_at_start(), 2U);
}

TEST(Stand, SplitsGroupsIntoTreesOnTheSamePatch) {
    Stand stand = stand_of({tree_at(1, 1, 1, 5), tree_at(2, 12, 12, 3)});
    stand.split_groups(5.0, 1, 0);
    EXPECT_EQ(stand.stems_standing(), 8U);
    ASSERT_EQ(stand.trees().size(), 8U);
    EXPECT_EQ(std::count_if(stand.trees().begin(), stand.trees().end(),
                            [](const Tree& tree) { return index_of(tree.patch) == 2; }),
              5);
    EXPECT_EQ(stand.balance().all_stems_in(), 0U) << "they were there before";
    EXPECT_EQ(stand.trees()[2].stems, 1U);
}

TEST(Stand, DropsTheWoundsOfTreesThatLeave) {
    Stand stand = stand_of({tree_at(1, 1, 1), tree_at(2, 2, 2)});
    stand.add_wounds(std::vector<Wound>{{.tree = TreeId{2}, .height_m = 1.5F},
                                        {.tree = TreeId{1}, .height_m = 0.5F},
                                        {.tree = TreeId{2}, .height_m = 0.5F},
                                        {.tree = TreeId{9}, .height_m = 0.5F}});
    ASSERT_EQ(stand.wounds_of(TreeId{2}).size(), 2U);
    EXPECT_FLOAT_EQ(stand.wounds_of(TreeId{2})[0].height_m, 0.5F);
    stand.remove_trees(std::vector<Removal>{{TreeId{2}, Cause::wound}});
    EXPECT_EQ(stand.wounds().size(), 1U);
    EXPECT_TRUE(stand.wounds_of(TreeId{2}).empty());
}

TEST(Stand, BalancesItsSaplings) {
    Stand stand = stand_of({});
    const Cohort cohort{.patch = PatchId{1}, .species = SpeciesId{1}, .stems = 20, .height_m = 0.05};
    stand.add_cohorts(std::vector<Cohort>{cohort, cohort, cohort});
    stand.remove_saplings(std::vector<SaplingRemoval>{{0, 5, Cause::browsing}, {1, 99, Cause::stress}});
    ASSERT_EQ(stand.cohorts().size(), 2U);
    const std::vector<std::size_t> grown{0};
    stand.recruit(grown, std::vector<Tree>{tree_at(0, 12, 12, 15)});

    const StandBalance& balance = stand.balance();
    EXPECT_EQ(balance.saplings_in,
              balance.saplings_recruited + balance.all_saplings_out() + stand.saplings_standing());
    EXPECT_EQ(balance.saplings_recruited, 15U);
    EXPECT_EQ(balance.all_stems_in(), 15U);
    EXPECT_EQ(stand.stems_standing(), 15U);
}

}  // namespace
}  // namespace forest::stand_test
