#include "coupling/inputs/forest/tops/bound_trees.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "config/random/stream.hpp"

namespace coupling::bound_trees_test {
namespace {

TreeRecord tree_at(double x_m, double y_m, double height_m, bool is_derived) {
    return {.id = "1",
            .species = "PIAB",
            .stem = {.x_m = x_m, .y_m = y_m, .dbh_cm = 1.2 * height_m, .height_m = height_m},
            .has_derived_dbh = is_derived};
}

std::vector<TreeRecord> random_trees(std::uint64_t id, std::size_t count) {
    config::RandomStream stream{{5, 0, 0, id}, config::Purpose::test};
    std::vector<TreeRecord> trees;
    for (std::size_t i = 0; i < count; ++i) {
        const double x_m = 80.0 * stream.uniform();
        const double y_m = 80.0 * stream.uniform();
        trees.push_back(tree_at(x_m, y_m, 5.0 + 30.0 * stream.uniform(), stream.uniform() < 0.7));
    }
    return trees;
}

/// Whether a stem of the thick forest is one of the list, or stands within 10 m of one of its size.
bool belongs_to(const rockfall::Stem& stem, const TreeRecord& tree) {
    return stem.height_m == tree.stem.height_m &&
           std::hypot(stem.x_m - tree.stem.x_m, stem.y_m - tree.stem.y_m) <= 10.0;
}

bool is_same(const rockfall::Stem& a, const rockfall::Stem& b) {
    return a.x_m == b.x_m && a.y_m == b.y_m && a.dbh_cm == b.dbh_cm && a.height_m == b.height_m;
}

RC_GTEST_PROP(BoundTrees, OfTopsLieAroundTheListAndKeepWhatWasMeasured, (std::uint64_t seed)) {
    const std::vector<TreeRecord> trees = random_trees(seed % 1000, 60);
    const BoundTrees bounds = bounds_of_tops(trees, seed);
    RC_ASSERT(bounds.thin.size() == trees.size());
    RC_ASSERT(bounds.thick.size() >= trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const double ratio = bounds.thin[i].dbh_cm / trees[i].stem.dbh_cm;
        const double wanted = trees[i].has_derived_dbh ? 0.6964 : 1.0;
        RC_ASSERT(std::abs(ratio - wanted) < 1e-3);
        RC_ASSERT(std::any_of(bounds.thick.begin(), bounds.thick.end(), [&](const rockfall::Stem& stem) {
            return stem.x_m == trees[i].stem.x_m && stem.y_m == trees[i].stem.y_m &&
                   stem.dbh_cm >= trees[i].stem.dbh_cm;
        }));
    }
    for (const rockfall::Stem& stem : bounds.thick) {
        RC_ASSERT(std::any_of(trees.begin(), trees.end(),
                              [&](const TreeRecord& tree) { return belongs_to(stem, tree); }));
    }
}

RC_GTEST_PROP(BoundTrees, OfTopsDoNotDependOnTheOrigin, (std::uint64_t seed)) {
    std::vector<TreeRecord> trees = random_trees(seed % 1000, 40);
    const BoundTrees bounds = bounds_of_tops(trees, seed);
    constexpr double east_m = 1024.0;  // exact
    for (TreeRecord& tree : trees) {
        tree.stem.x_m += east_m;
    }
    const BoundTrees moved = bounds_of_tops(trees, seed);
    RC_ASSERT(moved.thick.size() == bounds.thick.size());
    for (std::size_t i = 0; i < moved.thick.size(); ++i) {
        RC_ASSERT(std::abs(moved.thick[i].x_m - east_m - bounds.thick[i].x_m) < 1e-9);
        RC_ASSERT(moved.thick[i].dbh_cm == bounds.thick[i].dbh_cm);
    }
}

TEST(BoundTrees, AddAsManyAsAScanMisses) {
    // Trees of 10 m far from others are the highest around; beside one of 31 m few of them show.
    constexpr std::size_t count = 4000;
    std::vector<TreeRecord> alone;
    std::vector<TreeRecord> below_others;
    for (std::size_t i = 0; i < count; ++i) {
        alone.push_back(tree_at(40.0 * static_cast<double>(i), 0.0, 10.0, true));
        below_others.push_back(alone.back());
        below_others.push_back(tree_at(40.0 * static_cast<double>(i) + 5.0, 0.0, 31.0, true));
    }
    const auto added = [](const std::vector<TreeRecord>& trees) {
        return static_cast<double>(bounds_of_tops(trees, 3).thick.size() - trees.size());
    };
    const double of_highest = 5.0 / 21.0;  // 21 of 26 found
    const double of_low = 14.0 / 4.0;      // 4 of 18
    // The fraction of a tree is drawn: a variance of p (1 - p) each, four deviations.
    const double scatter = 4.0 * std::sqrt(count * 0.25);
    EXPECT_NEAR(added(alone), count * of_highest, scatter);
    EXPECT_NEAR(added(below_others), count * (of_highest + of_low), 1.5 * scatter);
}

RC_GTEST_PROP(BoundTrees, OfRecordsAreAPartOfTheTreesAndMoreThanThem, (std::uint64_t seed)) {
    const std::vector<TreeRecord> trees = random_trees(seed % 1000, 3000);
    const BoundTrees bounds = bounds_of_records(trees, seed);
    // As many are added as are taken out: 24.7 % of them, within five deviations.
    RC_ASSERT(bounds.thick.size() - trees.size() == trees.size() - bounds.thin.size());
    const auto missing = static_cast<double>(trees.size() - bounds.thin.size());
    RC_ASSERT(std::abs(missing - 740.25) < 5.0 * std::sqrt(3000.0 * 0.24675 * 0.75325));
    std::size_t next = 0;
    for (const rockfall::Stem& stem : bounds.thin) {
        while (next < trees.size() && !is_same(stem, trees[next].stem)) {
            ++next;
        }
        RC_ASSERT(next < trees.size());  // in the order of the list
    }
}

TEST(BoundTrees, ShareFoundRisesWithHeight) {
    for (double share = 0.0; share < 1.0; share += 0.01) {
        EXPECT_LE(share_found(share), share_found(share + 0.01));
        EXPECT_GT(share_found(share), 0.0);
        EXPECT_LE(share_found(share), 1.0);
    }
}

}  // namespace
}  // namespace coupling::bound_trees_test
