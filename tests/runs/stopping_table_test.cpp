#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling::stopping_table_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* recipe =
    "code,name,block_low_m,block_high_m,cover,burial,gathering,reason\n"
    "1,rock,0.2,0.8,0.001,0,0,single blocks\n"
    "3,talus,0.4,0.8,0.2,0.4,0.8,as mapped\n";

constexpr const char* quickly = " --surfaces 4 --throws 500 --diameters 0.4,0.5,1 --quiet";

TEST(StoppingTable, OfARecipeServesAScenario) {
    const SampleProject project;
    project.write("recipe.csv", recipe);
    const Outcome made =
        call(project, std::string{"stopping-table recipe.csv --out made --pictures"} + quickly);
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.out, "made/stopping.csv\n");
    for (const char* name :
         {"stopping.csv", "pictures/rock.svg", "pictures/talus.svg", "pictures/talus.ply"}) {
        EXPECT_TRUE(fs::exists(project.file("made") / name)) << name;
    }
    const Outcome run =
        call(project, "run scenario.ini --quiet --set terrain.stopping=made/stopping.csv --out with");
    EXPECT_EQ(run.code, 0) << run.err;
    const Outcome without = call(project, "run scenario.ini --quiet --out without");
    EXPECT_EQ(without.code, 0) << without.err;
    EXPECT_NE(project.read("with/tables/rocks.csv"), project.read("without/tables/rocks.csv"));
}

TEST(StoppingTable, IsTheSameOnAnyNumberOfThreads) {
    const SampleProject project;
    project.write("recipe.csv", recipe);
    const std::string command = std::string{"stopping-table recipe.csv"} + quickly;
    ASSERT_EQ(call(project, command + " --threads 1 --out one").code, 0);
    ASSERT_EQ(call(project, command + " --threads 3 --out three").code, 0);
    EXPECT_EQ(project.read("one/stopping.csv"), project.read("three/stopping.csv"));
    ASSERT_EQ(call(project, command + " --seed 2 --out other").code, 0);
    EXPECT_NE(project.read("one/stopping.csv"), project.read("other/stopping.csv"));
}

TEST(StoppingTable, ShowsAnOverviewOfTheShippedSurfaces) {
    const SampleProject project;
    const Outcome outcome = call(project,
                                 "stopping-table --out made --surface road --surface pasture --surfaces 4 "
                                 "--throws 100 --diameters 0.95");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* word : {"road", "pasture", "0.95 m", "±"}) {
        EXPECT_NE(outcome.out.find(word), std::string::npos) << outcome.out;
    }
    EXPECT_EQ(outcome.out.find("coarse_debris"), std::string::npos);
}

TEST(StoppingTable, KeepsATableThatIsThere) {
    const SampleProject project;
    project.write("recipe.csv", recipe);
    fs::create_directories(project.file("made"));
    project.write("made/stopping.csv", "mine\n");
    const std::string command = std::string{"stopping-table recipe.csv --out made"} + quickly;
    const Outcome refused = call(project, command);
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(
        refused.err,
        "bannwald: made/stopping.csv: found the file is there already, expected another folder by --out, "
        "or --overwrite to replace it\n");
    EXPECT_EQ(project.read("made/stopping.csv"), "mine\n");
    EXPECT_EQ(call(project, command + " --overwrite").code, 0);
    EXPECT_NE(project.read("made/stopping.csv"), "mine\n");
    EXPECT_FALSE(fs::exists(project.file("made/stopping.csv.part")));
}

}  // namespace
}  // namespace coupling::stopping_table_test
