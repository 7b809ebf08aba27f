// The table of impacts, through the program.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "config/table/table.hpp"
#include "tests/runs/program.hpp"

namespace coupling::impact_table_test {
namespace {

config::Table read_table(const SampleProject& project, const std::string& name) {
    std::istringstream in{project.read(name)};
    return config::Table::read(in, name);
}

TEST(ImpactTable, HasTheImpactsOfTheRocksThatWereAskedFor) {
    const SampleProject project;
    ASSERT_EQ(call(project,
                   "run scenario.ini --quiet --out out --set output.impact_table=yes --set "
                   "output.sample_paths=0 --set \"output.path_rocks=3, 11\"")
                  .code,
              0);
    const config::Table impacts = read_table(project, "out/tables/impacts.csv");
    ASSERT_GT(impacts.rows(), 4U);
    std::set<std::string> rocks;
    for (std::size_t row = 0; row < impacts.rows(); ++row) {
        rocks.insert(impacts.text(row, "rock"));
        const std::string& ground = impacts.text(row, "ground");
        EXPECT_TRUE(ground == "1" || ground == "3") << ground;
    }
    EXPECT_EQ(rocks, (std::set<std::string>{"3", "11"}));

    // The last impact of a rock that the ground stopped lies where rocks.csv has its end.
    const config::Table ends = read_table(project, "out/tables/rocks.csv");
    for (std::size_t row = 0; row < ends.rows(); ++row) {
        for (std::size_t i = 0; i < impacts.rows(); ++i) {
            if (impacts.text(i, "rock") == ends.text(row, "rock") &&
                impacts.text(i, "cover") == ends.text(row, "cover") && impacts.text(i, "onward") == "stops") {
                EXPECT_EQ(impacts.text(i, "x_m"), ends.text(row, "x_end_m"));
                EXPECT_EQ(impacts.text(i, "ground"), ends.text(row, "end_ground"));
            }
        }
    }
    ASSERT_EQ(call(project, "run scenario.ini --quiet --out without").code, 0);
    EXPECT_EQ(project.read("out/tables/rocks.csv"), project.read("without/tables/rocks.csv"));
    EXPECT_FALSE(std::filesystem::exists(project.file("without/tables/impacts.csv")));
}

}  // namespace
}  // namespace coupling::impact_table_test
