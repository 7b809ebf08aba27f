#include "coupling/inputs/files/input_names.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::input_names_test {
namespace {

namespace fs = std::filesystem;

class Names : public testing::Test {
protected:
    std::string shown(const std::string& name, const fs::path& folder) {
        return names_.shown(name, fs::path{name}.is_absolute() ? fs::path{name} : folder / name, folder);
    }
    SampleProject project_;
    InputNames names_;
};

TEST_F(Names, CountFromTheFolderOfTheScenario) {
    const fs::path folder = project_.folder();
    EXPECT_EQ(shown("dem.asc", folder), "dem.asc");
    EXPECT_EQ(shown("./maps//dem.asc", folder), "maps/dem.asc");
    EXPECT_EQ(shown((folder / "dem.asc").string(), folder), "dem.asc");
    EXPECT_EQ(shown("maps.gpkg|road", folder), "maps.gpkg|road");
    EXPECT_EQ(shown("", folder), "");
}

TEST_F(Names, HoldNoFoldersOfFilesElsewhere) {
    const fs::path folder = project_.file("project");
    fs::create_directories(folder);
    EXPECT_EQ(shown("../dem.asc", folder), "outside/dem.asc");
    EXPECT_EQ(shown((project_.folder() / "dem.prj").string(), folder), "outside/dem.prj");
    EXPECT_EQ(shown("/etc/dem.asc", folder), "outside_2/dem.asc");
    EXPECT_EQ(shown("../project/a.csv", folder), "a.csv");
}

TEST_F(Names, NeverMeanTwoFiles) {
    const fs::path folder = project_.file("project");
    fs::create_directories(folder / "outside");
    EXPECT_EQ(shown("outside/dem.asc", folder), "outside/dem.asc");
    EXPECT_EQ(shown("../dem.asc", folder), "outside_2/dem.asc");
}

TEST_F(Names, LeadBackToTheFiles) {
    const fs::path folder = project_.file("project");
    fs::create_directories(folder);
    EXPECT_EQ(names_.path_of(shown("trees.csv", folder)), (folder / "trees.csv").string());
    EXPECT_EQ(names_.path_of(shown("../dem.asc", folder)), (folder / "../dem.asc").string());
    // A part of the same data set that had no name of its own.
    EXPECT_TRUE(fs::equivalent(names_.path_of("outside/dem.prj"), project_.file("dem.prj")));
    EXPECT_EQ(names_.path_of("--set run.seed=1"), "--set run.seed=1");
}

TEST_F(Names, FollowLinksOutOfAFolder) {
    const fs::path folder = project_.file("project");
    fs::create_directories(folder);
    fs::create_directory_symlink("/etc", folder / "link");
    EXPECT_FALSE(is_within(folder / "link/passwd", folder));
    EXPECT_FALSE(is_within(folder / "../dem.asc", folder));
    EXPECT_FALSE(is_within("/etc/passwd", folder));
    EXPECT_TRUE(is_within(folder / "new/dem.asc", folder));
}

}  // namespace
}  // namespace coupling::input_names_test
