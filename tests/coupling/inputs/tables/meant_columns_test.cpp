#include "coupling/inputs/tables/meant_columns.hpp"

#include <gtest/gtest.h>

#include "coupling/inputs/release/source_start.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::doubtful_columns_test {
namespace {

TEST(MeantColumn, FindsTheQuantityWithoutItsUnitOrInAnother) {
    const std::vector<std::string> known = source_shape_columns().names();
    EXPECT_EQ(meant_column("speed", known), "speed_mps");
    EXPECT_EQ(meant_column("velocity_mps", known), "speed_mps");
    EXPECT_EQ(meant_column("speed_kmh", known), "speed_mps");
    EXPECT_EQ(meant_column("mass", known), "mass_t");
    EXPECT_EQ(meant_column("mass_tonnes", known), "mass_t");
    EXPECT_EQ(meant_column("Diameter", known), "diameter_m");
    EXPECT_EQ(meant_column("block", known), "blocks");
    EXPECT_EQ(meant_column("gap", {"gap_m"}), "gap_m");
}

TEST(MeantColumn, FindsTheSameLettersAndLeavesOtherWordsAlone) {
    EXPECT_EQ(meant_column("rt", {"r_n", "r_t"}), "r_t");
    EXPECT_EQ(meant_column("r_t_percent", {"r_n", "r_t"}), "r_t");
    EXPECT_EQ(meant_column("r_t [%]", {"r_n", "r_t"}), "r_t");
    EXPECT_EQ(meant_column("treshold_deg", {"threshold_deg"}), "threshold_deg");
    EXPECT_EQ(meant_column("remarks", source_shape_columns().names()), "");
    EXPECT_EQ(meant_column("id", source_shape_columns().names()), "");
}

TEST(FormulaDoubts, NameIdsThatASpreadsheetComputes) {
    const config::Table table = config::Table::read(
        std::string_view{"tree_id,name,label,x_m,note\n=1+1,a,-,-3,=x\n-5,+A1,b,=2,y\n@sum,-b,c,1,z\n"},
        "trees.csv");
    const std::vector<config::Problem> found = formula_warnings(table);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(config::to_string(found[0]).starts_with(
        "trees.csv:2:1: found tree_id '=1+1' and 1 more such text, which a spreadsheet "
        "takes for a formula when it opens the results, expected texts that do not "
        "begin with =, +, - or @"))
        << config::to_string(found[0]);
    EXPECT_TRUE(config::to_string(found[1]).starts_with("trees.csv:3:4: found name '+A1' and 1 more"))
        << config::to_string(found[1]);
}

}  // namespace
}  // namespace coupling::doubtful_columns_test
