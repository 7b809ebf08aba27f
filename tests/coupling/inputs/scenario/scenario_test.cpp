#include "coupling/inputs/scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::scenario_test {
namespace {

TEST(Scenario, FindsFilesBesideItself) {
    Scenario scenario;
    scenario.file = "/projects/lech/scenario.ini";
    EXPECT_EQ(scenario.resolve("dem.asc"), "/projects/lech/dem.asc");
    EXPECT_EQ(scenario.resolve("/data/dem.asc"), "/data/dem.asc");
}

TEST(Scenario, NamesFilesByTheShortestWayThatIsTheSame) {
    const SampleProject project;
    namespace fs = std::filesystem;
    fs::create_directories(project.file("a/b"));
    fs::create_directory_symlink(project.file("a/b"), project.file("link"));
    Scenario scenario;
    scenario.file = project.file("a/scenario.ini");
    EXPECT_EQ(scenario.resolve("../dem.asc"), project.file("dem.asc"));
    // Behind a link the way up leads to a/, not to the project.
    scenario.file = project.file("link/scenario.ini");
    EXPECT_EQ(scenario.resolve("../dem.asc"), project.file("link/../dem.asc"));
}

TEST(Settings, NeedOthersThatExistWithValuesThatTheyCanHave) {
    config::Options options;
    Scenario scenario;
    declare(options, scenario);
    const std::vector<config::ParameterRow> rows = options.rows();
    std::size_t needs = 0;
    for (const config::ParameterRow& row : rows) {
        for (const config::Need& need : row.needs) {
            ++needs;
            const auto other =
                std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.key == need.key; });
            ASSERT_NE(other, rows.end()) << row.key << " needs " << need.key;
            EXPECT_NE(other->key, row.key);
            for (const std::string& value : need.values) {
                std::istringstream none;
                EXPECT_NO_THROW(options.read(none, "scenario.ini", {need.key + "=" + value}))
                    << row.key << " needs " << need.key << " = " << value;
            }
        }
    }
    EXPECT_GT(needs, 40U);
}

TEST(StartLaw, DropsRocksFromTheFallHeight) {
    Scenario scenario;
    scenario.release.start_dip_deg = 45.0;
    EXPECT_EQ(start_law(scenario.release).height_m, 1.5);
    EXPECT_EQ(start_law(scenario.release).speed_mps, 3.0);
    EXPECT_DOUBLE_EQ(start_law(scenario.release).dip.in_degrees(), 45.0);
    scenario.release.fall_height_m = 12.0;
    EXPECT_EQ(start_law(scenario.release).height_m, 12.0);
    EXPECT_EQ(start_law(scenario.release).speed_mps, 0.0);
}

TEST(StartLaw, LeavesOutClassesThatNeverOccur) {
    Scenario scenario;
    scenario.release.diameter_kind = DiameterKind::classes;
    scenario.release.diameter_classes_m = {0.5, 1.0, 3.0};
    scenario.release.diameter_shares = {3.0, 1.0, 0.0};
    const rockfall::DiameterLaw law = start_law(scenario.release).diameter;
    EXPECT_EQ(law.at(0.7), 0.5);
    EXPECT_EQ(law.at(0.8), 1.0);
    EXPECT_EQ(law.largest_m(), 1.0);
}

}  // namespace
}  // namespace coupling::scenario_test
