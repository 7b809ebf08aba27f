#include "coupling/inputs/plausible/close_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::plausible::close_trees_test {
namespace {

struct Stem {
    double x_m, y_m, dbh_cm;
};

double even(std::mt19937& random, double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 32>(random);
}

/// Spruces at random places of a hectare: as near to each other as chance allows, nearer than in any stand.
std::vector<Stem> stand_of(int stems, double low_cm, double high_cm, std::mt19937& random) {
    std::vector<Stem> stand;
    for (int i = 0; i < stems; ++i) {
        stand.push_back({even(random, 0.0, 100.0), even(random, 0.0, 100.0), even(random, low_cm, high_cm)});
    }
    return stand;
}

/// With a second census of the same trees: as far off as two surveys differ, and grown.
std::vector<Stem> with_second_census(std::vector<Stem> stand, double off_m, std::mt19937& random) {
    const std::size_t trees = stand.size();
    for (std::size_t i = 0; i < trees; ++i) {
        stand.push_back({stand[i].x_m + off_m * even(random, -0.7, 0.7),
                         stand[i].y_m + off_m * even(random, -0.7, 0.7), 1.05 * stand[i].dbh_cm});
    }
    return stand;
}

std::string text_of(const std::vector<Stem>& stand) {
    std::ostringstream text;
    text.precision(12);
    text << "x_m,y_m,species,dbh_cm\n";
    for (const Stem& stem : stand) {
        text << stem.x_m << ',' << stem.y_m << ",PIAB," << stem.dbh_cm << '\n';
    }
    return text.str();
}

CloseTrees found_in(const std::vector<Stem>& stand) {
    std::istringstream in{text_of(stand)};
    return close_trees(config::Table::read(in, "trees.csv"));
}

TEST(CloseTrees, AreFewInStandsAndThickets) {
    std::mt19937 random{3};
    for (const int stems : {200, 800, 1600}) {
        const std::vector<Stem> stand = stand_of(stems, 12.0, 40.0, random);
        EXPECT_FALSE(are_too_close(found_in(stand), stand.size())) << stems;
    }
    const std::vector<Stem> thicket = stand_of(6000, 2.0, 9.0, random);
    EXPECT_FALSE(are_too_close(found_in(thicket), thicket.size()));
}

TEST(CloseTrees, AreHalfOfTwoCensusesHoweverTheyWereMeasured) {
    std::mt19937 random{4};
    for (const double off_m : {0.0, 0.05, 0.3}) {
        const std::vector<Stem> stand = with_second_census(stand_of(400, 12.0, 40.0, random), off_m, random);
        EXPECT_TRUE(are_too_close(found_in(stand), stand.size())) << off_m;
    }
}

/// Groups are counted less their first: that does not depend on which row comes first.
TEST(CloseTrees, AreTheSameForTurnedMirroredAndShuffledLists) {
    std::mt19937 random{5};
    std::vector<Stem> stand = with_second_census(stand_of(300, 12.0, 40.0, random), 0.05, random);
    const CloseTrees straight = found_in(stand);
    std::shuffle(stand.begin(), stand.end(), random);
    for (int turn = 0; turn < 8; ++turn) {
        for (Stem& stem : stand) {
            stem = turn == 4 ? Stem{stem.y_m, stem.x_m, stem.dbh_cm} : Stem{-stem.y_m, stem.x_m, stem.dbh_cm};
        }
        const CloseTrees found = found_in(stand);
        EXPECT_EQ(found.inside, straight.inside);
        EXPECT_EQ(found.twins, straight.twins);
        EXPECT_TRUE(are_too_close(found, stand.size()));
    }
}

// One tree of 1 m on each cell of 20 m: pi / 4 m2 on 0.04 ha; turned by a right angle, mirrored, moved.
TEST(BasalAreaWhereTreesStand, IsThatOfTheCellsThatHoldATree) {
    std::vector<plausible::PlacedTree> trees;
    for (int i = 0; i < 5; ++i) {
        trees.push_back({20.0 * i + 3.0, 100.0 * i + 7.0, 100.0});
    }
    const double expected_m2pha = 0.25 * M_PI / 0.04;
    EXPECT_NEAR(plausible::basal_area_where_trees_stand_m2pha(trees), expected_m2pha, 1e-9);
    for (plausible::PlacedTree& tree : trees) {
        tree = {-tree.y_m, tree.x_m + 2000.0, tree.dbh_cm};
    }
    EXPECT_NEAR(plausible::basal_area_where_trees_stand_m2pha(trees), expected_m2pha, 1e-9);
    trees.push_back(trees.front());
    EXPECT_NEAR(plausible::basal_area_where_trees_stand_m2pha(trees), 1.2 * expected_m2pha, 1e-9);
    EXPECT_EQ(plausible::basal_area_where_trees_stand_m2pha({}), 0.0);
}

}  // namespace
}  // namespace coupling::plausible::close_trees_test
