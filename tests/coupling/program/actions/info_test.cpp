#include "coupling/program/actions/info.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/errors/input_error.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::info_test {
namespace {

std::string info_on(const std::string& name) {
    std::ostringstream out;
    write_info(name, "", out);
    return out.str();
}

TEST(Info, TellsFrameRangeAndProjectionOfAGrid) {
    const SampleProject project;
    project.replace("dem.asc", "400", "-9999");
    EXPECT_EQ(info_on(project.file("dem.asc").string()),
              "ESRI ASCII grid\n"
              "frame         12 x 10 cells of 10 m, corner 1000, 2000\n"
              "extent        x 1000 to 1120, y 2000 to 2100\n"
              "projection    Sample\n"
              "NODATA        0.83 % of the cells\n"
              "range         323 to 400, mean 361.17648\n"
              "values        323: 10 cells  330: 10 cells  337: 10 cells  344: 10 cells  351: 10 cells  358: "
              "10 cells  "
              "365: 10 cells  372: 10 cells  379: 10 cells  386: 10 cells  393: 10 cells  400: 9 cells\n");
}

TEST(Info, TellsColumnsAndRowsOfATable) {
    const SampleProject project;
    const std::string text = info_on(project.file("trees.csv").string());
    EXPECT_TRUE(text.starts_with("CSV table\nrows          3\n")) << text;
    EXPECT_NE(text.find("dbh_cm               20 to 41"), std::string::npos) << text;
    EXPECT_NE(text.find("3 different texts"), std::string::npos) << text;
}

TEST(Info, PrintsShippedTables) {
    EXPECT_NE(info_on("surfaces").find("forest_soil_deep"), std::string::npos);
    EXPECT_THROW(info_on("no_such_table"), config::InputError);
}

TEST(Info, ListsTheColumnsOfRegimesAndPrintsShippedOnes) {
    const std::string text = info_on("regimes");
    EXPECT_NE(text.find("  pfm1\n"), std::string::npos) << text;
    EXPECT_NE(
        text.find("\nstump_height_m          1.0-1.3 for high stumps; for all cuts, salvage; default 0.3"),
        std::string::npos)
        << text;
    EXPECT_NE(info_on("pfm1").find("slits,clear_cut,0,20"), std::string::npos);
}

}  // namespace
}  // namespace coupling::info_test
