#include "coupling/inputs/plausible/unlike_trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"

namespace coupling::plausible::unlike_trees_test {
namespace {

struct Tree {
    double dbh_cm;
    double height_m;
};

/// Spread evenly over [0, 1), in no order of the rows.
double spread(int i, double step) {
    return std::fmod(step * i + 0.37, 1.0);
}

/// A mixed-age stand: heights level off, and diameters of trees of one height differ by a factor of two.
std::vector<Tree> stand(int trees) {
    std::vector<Tree> all;
    for (int i = 0; i < trees; ++i) {
        const double dbh_cm = 8.0 * std::pow(9.0, spread(i, 0.618034));
        const double scatter = std::exp(0.5 * (spread(i, 0.414214) - 0.5));
        all.push_back({dbh_cm, 1.3 + 36.0 * (1.0 - std::exp(-dbh_cm / 28.0)) * scatter});
    }
    return all;
}

UnlikeTrees found_in(const std::vector<Tree>& trees, const std::function<Tree(int, Tree)>& written) {
    std::string text = "dbh_cm,height_m\n";
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Tree tree = written(static_cast<int>(i), trees[i]);
        text += config::to_text(tree.dbh_cm) + "," + config::to_text(tree.height_m) + "\n";
    }
    std::istringstream in{text};
    return unlike_trees(config::Table::read(in, "trees.csv"));
}

Tree with_girth(const Tree& tree) {
    return {3.14159 * tree.dbh_cm, tree.height_m};
}

TEST(UnlikeTrees, AreNoneInAStand) {
    for (const int trees : {15, 40, 300, 3000}) {
        const UnlikeTrees found = found_in(stand(trees), [](int, Tree tree) { return tree; });
        EXPECT_TRUE(found.girth_lines.empty()) << trees;
        EXPECT_TRUE(found.swapped_lines.empty()) << trees;
    }
}

TEST(UnlikeTrees, AreGirthsInAPartOfTheRows) {
    for (const int one_in : {3, 5, 10, 20}) {
        const UnlikeTrees found = found_in(
            stand(1000), [&](int i, Tree tree) { return i % one_in == 0 ? with_girth(tree) : tree; });
        const double share = static_cast<double>(found.girth_lines.size()) * one_in / 1000.0;
        EXPECT_GT(share, 0.7) << one_in;
        EXPECT_LT(share, 1.1) << one_in;
        for (const std::size_t line : found.girth_lines) {
            EXPECT_EQ((line - 2) % static_cast<std::size_t>(one_in), 0U) << "line " << line;
        }
    }
    // A whole plot of the list.
    const UnlikeTrees plot =
        found_in(stand(1000), [](int i, Tree tree) { return i >= 600 && i < 800 ? with_girth(tree) : tree; });
    ASSERT_FALSE(plot.girth_lines.empty());
    EXPECT_GE(plot.girth_lines.front(), 602U);
    EXPECT_LE(plot.girth_lines.back(), 801U);
}

/// Thick trees of the open are a tail of the list, however many: they do not gather at 3.14 times.
TEST(UnlikeTrees, AreNotThickTreesOfTheOpen) {
    const UnlikeTrees found = found_in(stand(1000), [](int i, Tree tree) {
        return i % 8 == 0 ? Tree{tree.dbh_cm * std::exp(1.0 * spread(i, 0.7320508)), tree.height_m} : tree;
    });
    EXPECT_TRUE(found.girth_lines.empty()) << found.girth_lines.size();
}

TEST(UnlikeTrees, AreRowsWithSwappedFields) {
    const UnlikeTrees found = found_in(stand(1000), [](int i, Tree tree) {
        return i % 10 == 0 ? Tree{tree.height_m, tree.dbh_cm} : tree;
    });
    EXPECT_GT(found.swapped_lines.size(), 20U) << "those of about 100 times look like others";
    for (const std::size_t line : found.swapped_lines) {
        EXPECT_EQ((line - 2) % 10, 0U) << "line " << line;
    }
    EXPECT_TRUE(found.girth_lines.empty());
}

/// Metres and decimetres make trees as slender, but no tree of the list is like that with swapped fields.
TEST(UnlikeTrees, AreNotSwappedWhereTheUnitIsAnother) {
    for (const double factor : {0.01, 0.1}) {
        const UnlikeTrees found = found_in(stand(1000), [&](int i, Tree tree) {
            return i % 10 == 0 ? Tree{factor * tree.dbh_cm, tree.height_m} : tree;
        });
        EXPECT_LT(found.swapped_lines.size(), 10U) << factor;
    }
}

}  // namespace
}  // namespace coupling::plausible::unlike_trees_test
