#include "coupling/inputs/tables/meant_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coupling/inputs/release/source_start.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::doubtful_columns_test {
namespace {

bool has(const std::vector<std::string>& warnings, const std::string& wanted) {
    return std::find(warnings.begin(), warnings.end(), wanted) != warnings.end();
}

std::string doubt_of(const std::string& file, const std::string& column, const std::string& meant) {
    return file + ": found column '" + column + "', which is passed over, expected " + meant +
           ", if that is what is meant";
}

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

TEST(DoubtColumns, TellsThoseOfSoilsAndGroundTypes) {
    const SampleProject project;
    project.write("surface_types.csv", "code,like,sol\n1,solid_rock,meadow\n3,solid_rock,meadow\n");
    EXPECT_TRUE(has(open(project).warnings, doubt_of("surface_types.csv", "sol", "soil")));
    // A column of soils that means nothing is refused.
    project.write("soils.csv", "name,like,rtan,treshold_deg\nmeadow,soft_soil_step_1,0.75,5\n");
    const Opened opened = open(project, {"terrain.soils=soils.csv"});
    EXPECT_EQ(opened.code, config::ExitCode::data);
    EXPECT_NE(opened.errors.find("'rtan'"), std::string::npos) << opened.errors;
    EXPECT_NE(opened.errors.find("'treshold_deg'"), std::string::npos) << opened.errors;
}

TEST(DoubtColumns, TellsThoseOfSourcesAndRefusesThemWhereInputsAreStrict) {
    const SampleProject project;
    project.write("cliff.csv", "wkt,velocity,mass\nPOINT (1030 2050),4,2\n");
    const std::vector<std::string> settings{"release.source=", "release.source_shapes=cliff.csv"};
    const Opened opened = open(project, settings);
    EXPECT_TRUE(has(opened.warnings, doubt_of("cliff.csv", "velocity", "speed_mps")));
    EXPECT_TRUE(has(opened.warnings, doubt_of("cliff.csv", "mass", "mass_t")));
    std::vector<std::string> strict = settings;
    strict.emplace_back("run.strict_inputs=yes");
    EXPECT_EQ(open(project, strict).code, config::ExitCode::data);
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
