#include "coupling/results/tables/table_of.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <vector>

#include "tests/coupling/results/small_run.hpp"

namespace coupling::table_of_test {
namespace {

struct Block {
    double mass_t;
    std::optional<int> piece;
};

struct Tree {
    std::string name;
    std::int32_t age_years;
    double height_m;
    bool broken;
    const Block* hit_by;
    std::vector<double> shares;
};

/// Columns of all kinds: of a part that may be missing, and those that only a run knows.
TableOf<Tree> tree_table(std::size_t shares) {
    ColumnsOf<Tree> of_run;
    for (std::size_t i = 0; i < shares; ++i) {
        of_run += {"share_" + std::to_string(i), 1, "a share", "a test",
                   [i](const Tree& tree) { return tree.shares[i]; }};
    }
    return {"trees.csv",
            "Every tree.",
            "a tree",
            {{"name", "its name", "a test", &Tree::name},
             {"age_years", "its age", &Tree::age_years},
             {"height_m", 2, "its height", "a test", &Tree::height_m},
             {"height_as_given_m", as_given, "the same", &Tree::height_m},
             {"broken", "yes or no", "a test", &Tree::broken},
             {ColumnsOf<Block>{{"mass_t", "t", 0, "mass of the block that hit it", "a test", &Block::mass_t},
                               {"piece", "its piece", "a test", &Block::piece}},
              &Tree::hit_by},
             of_run}};
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::string written(const std::vector<Tree>& trees) {
    std::ostringstream out;
    tree_table(2).write_to(out, [&](auto& rows) { rows.add_all(trees); });
    return out.str();
}

TEST(TableOf, WritesHeaderAndRowsFromItsColumns) {
    const Block block{2.6, 7};
    EXPECT_EQ(written({{"a, b", -3, 1.256, true, &block, {0.25, 1.0}}}),
              "name,age_years,height_m,height_as_given_m,broken,mass_t,piece,share_0,share_1\n"
              "\"a, b\",-3,1.26,1.256,yes,3,7,0.3,1.0\n");
}

TEST(TableOf, LeavesFieldsEmptyWhoseValuesAreMissing) {
    const Block whole{1.0, std::nullopt};
    const std::string text =
        written({{"", 0, unknown, false, nullptr, {unknown, 0.0}},
                 {"c", 1, std::numeric_limits<double>::infinity(), false, &whole, {0.0, 0.0}}});
    EXPECT_NE(text.find("\n,0,,,no,,,,0.0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nc,1,,,no,1,,0.0,0.0\n"), std::string::npos) << text;
}

TEST(TableOf, SaysWhatItsColumnsHold) {
    const TableOf<Tree> table = tree_table(1);
    std::vector<Holds> held;
    std::string units;
    for (const Column& column : table.columns) {
        held.push_back(column.holds);
        units += column.unit + ' ';
    }
    EXPECT_EQ(units, "text years m m text t - - ");
    EXPECT_EQ(held, (std::vector{Holds::text, Holds::whole, Holds::number, Holds::number, Holds::text,
                                 Holds::number, Holds::whole, Holds::number}));
}

TEST(TableOf, WritesAFileWithWhatItHolds) {
    const small_runs::TestFolder folder;
    const WrittenFile file = tree_table(0).write(folder.path(), [](auto&) {});
    EXPECT_EQ(file.path, "tables/trees.csv");
    EXPECT_EQ(file.sentence, "Every tree.");
    EXPECT_EQ(small_runs::text_of(folder.path() / file.path),
              "name,age_years,height_m,height_as_given_m,broken,mass_t,piece\n");
}

}  // namespace
}  // namespace coupling::table_of_test
