#include "forest/production/tree_differences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace forest::tree_differences_test {
namespace {

/// Trees of one diameter with identities from 0 on.
std::vector<Tree> equal_trees(std::size_t count, double dbh_cm) {
    std::vector<Tree> trees(count);
    for (std::size_t i = 0; i < count; ++i) {
        trees[i].id = TreeId{i};
        trees[i].dbh_cm = dbh_cm;
    }
    return trees;
}

TEST(GrowthFactors, HaveMeanOneAndTheDeviationAskedForInTheirLogarithm) {
    constexpr std::size_t count = 200'000;
    const std::vector<Tree> trees = equal_trees(count, 20.0);
    for (const double spread : {0.1, 0.3, 0.6}) {
        double sum = 0.0;
        double log_sum = 0.0;
        double log_squares = 0.0;
        for (const double factor : growth_factors(trees, {.growth = spread}, 7, 2)) {
            EXPECT_GT(factor, 0.0);
            sum += factor;
            log_sum += std::log(factor);
            log_squares += std::log(factor) * std::log(factor);
        }
        const double variance = std::exp(spread * spread) - 1.0;  // of a log-normal value with mean 1
        EXPECT_NEAR(sum / count, 1.0, 4.0 * std::sqrt(variance / count));
        const double log_mean = log_sum / count;
        EXPECT_NEAR(log_mean, -0.5 * spread * spread, 4.0 * spread / std::sqrt(count));
        EXPECT_NEAR(std::sqrt(log_squares / count - log_mean * log_mean), spread,
                    4.0 * spread / std::sqrt(2.0 * count));
    }
}

TEST(GrowthFactors, BelongToTheTreeWhateverStandsAroundIt) {
    std::vector<Tree> trees = equal_trees(300, 20.0);
    const std::vector<double> before = growth_factors(trees, {}, 7, 2);
    std::reverse(trees.begin(), trees.end());
    trees.resize(120);
    for (Tree& tree : trees) {
        tree.dbh_cm *= 2.0;
        tree.age_years += 50.0;
    }
    const std::vector<double> after = growth_factors(trees, {}, 7, 2);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        EXPECT_EQ(after[i], before[number_of(trees[i].id)]);
    }
}

TEST(GrowthFactors, AreOthersInEachReplicateAndWithEachSeed) {
    const std::vector<Tree> trees = equal_trees(50, 20.0);
    const std::vector<double> one = growth_factors(trees, {}, 7, 2);
    for (const std::vector<double>& other :
         {growth_factors(trees, {}, 7, 3), growth_factors(trees, {}, 8, 2)}) {
        for (std::size_t i = 0; i < trees.size(); ++i) {
            EXPECT_NE(one[i], other[i]);
        }
    }
}

TEST(GrowthFactors, AreOneForGroupsOfThinTreesAndWithoutDifferences) {
    const std::vector<double> ones(50, 1.0);
    EXPECT_EQ(growth_factors(equal_trees(50, 0.99 * single_tree_cm), {}, 7, 2), ones);
    EXPECT_EQ(growth_factors(equal_trees(50, 20.0), {.growth = 0.0}, 7, 2), ones);
    EXPECT_NE(growth_factors(equal_trees(50, single_tree_cm), {}, 7, 2), ones);
}

}  // namespace
}  // namespace forest::tree_differences_test
