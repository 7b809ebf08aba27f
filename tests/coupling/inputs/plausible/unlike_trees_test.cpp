#include "coupling/inputs/plausible/unlike_trees.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "config/random/stream.hpp"
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

/// Trees as in stand(), by chance.
std::vector<Tree> random_stand(int trees, config::RandomStream& stream) {
    std::vector<Tree> all;
    for (int i = 0; i < trees; ++i) {
        const double dbh_cm = 8.0 * std::pow(9.0, stream.uniform());
        const double scatter = std::exp(0.5 * (stream.uniform() - 0.5));
        all.push_back({dbh_cm, 1.3 + 36.0 * (1.0 - std::exp(-dbh_cm / 28.0)) * scatter});
    }
    return all;
}

/// How many of the swapped rows that can be seen were found: of trees whose diameter in cm is 1.5 times their
/// height in m or more. Others look like another tree of the list with their fields swapped.
struct SwappedRows {
    int clear = 0;
    int clear_found = 0;
    int wrongly_named = 0;
};

/// Up to a tenth of the rows, at least one.
SwappedRows swap_by_chance(int trees, config::RandomStream& stream) {
    const std::vector<Tree> stand = random_stand(trees, stream);
    std::set<int> swapped;
    const int most = std::max(1, trees / 10);
    const int rows = 1 + static_cast<int>(stream.uniform() * most);
    while (static_cast<int>(swapped.size()) < rows) {
        swapped.insert(static_cast<int>(stream.uniform() * trees));
    }
    const UnlikeTrees found = found_in(stand, [&](int i, Tree tree) {
        return swapped.contains(i) ? Tree{tree.height_m, tree.dbh_cm} : tree;
    });
    SwappedRows rows_of;
    std::set<int> named;
    for (const std::size_t line : found.swapped_lines) {
        const int row = static_cast<int>(line) - 2;
        named.insert(row);
        rows_of.wrongly_named += swapped.contains(row) ? 0 : 1;
    }
    for (const int row : swapped) {
        const Tree& tree = stand[static_cast<std::size_t>(row)];
        if (tree.dbh_cm >= 1.5 * tree.height_m) {
            ++rows_of.clear;
            rows_of.clear_found += named.contains(row) ? 1 : 0;
        }
    }
    return rows_of;
}

/// What is guaranteed, by the size of the list; the shares are a little below those of 400 lists each.
TEST(UnlikeTrees, AreRowsWithSwappedFieldsByTheSizeOfTheList) {
    struct Size {
        int trees;
        double least_share;
    };
    for (const Size& size : {Size{20, 0.3}, Size{25, 0.5}, Size{30, 0.6}, Size{40, 0.75}, Size{60, 0.85},
                             Size{100, 0.9}, Size{200, 0.9}, Size{500, 0.9}}) {
        config::RandomStream stream{{.seed = 3}, config::Purpose::sampling};
        SwappedRows all;
        for (int list = 0; list < 200; ++list) {
            const SwappedRows one = swap_by_chance(size.trees, stream);
            all.clear += one.clear;
            all.clear_found += one.clear_found;
            all.wrongly_named += one.wrongly_named;
        }
        EXPECT_GT(all.clear, 30) << size.trees;
        EXPECT_GE(all.clear_found, size.least_share * all.clear) << size.trees << " trees, " << all.clear;
        EXPECT_LE(all.wrongly_named, size.trees < 60 ? 2 : 0) << size.trees;
    }
}

/// Of 6000 lists of 20 trees six have a right row that is named, of 40 one, from 60 on none.
RC_GTEST_PROP(UnlikeTrees, NameHardlyARightRowAsSwappedAndJudgeNoShortList, ()) {
    const int trees = *rc::gen::inRange(5, 501);
    config::RandomStream stream{{.seed = *rc::gen::arbitrary<std::uint32_t>()}, config::Purpose::sampling};
    const SwappedRows rows = swap_by_chance(trees, stream);
    RC_ASSERT(rows.wrongly_named <= 1);
    RC_ASSERT(trees >= 20 || rows.clear_found + rows.wrongly_named == 0);
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
