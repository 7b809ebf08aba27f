#include "coupling/results/text/scenario_names.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::report::scenario_names_test {
namespace {

namespace fs = std::filesystem;

/// A scenario in a folder of its own, whose terrain lies beside that and whose trees a whole path names.
class Folders : public testing::Test {
protected:
    Folders() {
        fs::create_directories(project_.file("own/sub"));
        fs::create_directories(project_.file("maps,old"));
        fs::create_directories(project_.file("lists"));
        whole_ = project_.file("lists/trees.csv").string();
        project_.write("own/scenario.ini",
                       "[terrain]\nground = forest_soil\ndem = ../maps,old/dem.asc\n[trees]\nfile = " +
                           whole_ + "\n[release]\nsource = sub/source.asc\n");
        scenario_ = read_scenario(project_.file("own/scenario.ini"), {});
    }
    [[nodiscard]] FolderNames on_screen() const {
        return folder_names(*scenario_->names,
                            {{scenario_->shown(whole_), whole_},
                             {scenario_->shown("../maps,old/dem.asc"), "../maps,old/dem.asc"}});
    }
    SampleProject project_;
    std::string whole_;
    std::unique_ptr<Scenario> scenario_;
};

TEST_F(Folders, AreNamedAsTheScenarioHasThem) {
    const std::string dem = scenario_->shown("../maps,old/dem.asc");
    const std::string trees = scenario_->shown(whole_);
    ASSERT_TRUE(dem.starts_with(outside_folder) && trees.starts_with(outside_folder)) << dem << trees;
    const std::string sentence =
        dem + ":3: found 2 layers; write '" + trees + "|a' (" + dem + "), not a=" + dem;
    EXPECT_EQ(with_folder_names(sentence, on_screen()),
              "../maps,old/dem.asc:3: found 2 layers; write '" + whole_ +
                  "|a' (../maps,old/dem.asc), not a=../maps,old/dem.asc");
    EXPECT_EQ(with_folder_names(sentence, scenario_names(*scenario_)),
              "../maps,old/dem.asc:3: found 2 layers; write 'trees.csv|a' (../maps,old/dem.asc), not "
              "a=../maps,old/dem.asc");
    // What only looks like such a name stays.
    for (const char* other :
         {"trees outside the terrain", "my_outside/a.asc", "outside_99/a.asc", "outside"}) {
        EXPECT_EQ(with_folder_names(other, on_screen()), other);
    }
}

TEST_F(Folders, OfTablesShowNoPathOnPages) {
    fs::create_directories(project_.file("third"));
    const std::string listed = scenario_->shown(project_.file("third/tile.asc").string());
    EXPECT_EQ(with_folder_names(listed, scenario_names(*scenario_)), "tile.asc");
    EXPECT_TRUE(fs::equivalent(fs::path{with_folder_names(listed, on_screen())}.parent_path(),
                               project_.file("third")));
}

TEST_F(Folders, StandInEveryPartOfAProblem) {
    const std::string dem = scenario_->shown("../maps,old/dem.asc");
    try {
        scenario_->with_paths(
            [&] { config::fail(config::ExitCode::data, {dem}, dem, dem, "write " + dem + "|a"); });
        FAIL();
    } catch (const config::InputError& error) {
        EXPECT_EQ(std::string{error.what()}.find(outside_folder), std::string::npos) << error.what();
        EXPECT_EQ(error.problems().front().advice, "write ../maps,old/dem.asc|a");
        EXPECT_TRUE(fs::equivalent(fs::path{error.problems().front().place.file}.parent_path(),
                                   project_.file("maps,old")));
    }
}

TEST_F(Folders, AreKeptInArchives) {
    const FolderNames names = scenario_names(*scenario_);
    EXPECT_EQ(names.size(), 2U);
    EXPECT_EQ(folder_names_of(text_of(names)), names);
    fs::create_directories(project_.file("own/outside"));
    fs::create_directories(project_.file("own/outside_2"));
    project_.write("own/bannwald_folders.txt", text_of(names));
    const auto repeated = read_scenario(project_.file("own/scenario.ini"),
                                        {"terrain.dem=outside/dem.asc", "trees.file=outside_2/trees.csv"},
                                        project_.file("own"));
    EXPECT_EQ(scenario_names(*repeated), names);
}

}  // namespace
}  // namespace coupling::report::scenario_names_test
