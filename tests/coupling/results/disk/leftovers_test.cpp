#include "coupling/results/disk/leftovers.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "coupling/results/disk/byte_archive.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::leftovers_test {
namespace {

namespace fs = std::filesystem;

TEST(Leftovers, AreTheFilesOfThisNameThatNoProcessWorksOn) {
    const small_runs::TestFolder test;
    const fs::path file = test.path() / "out.zip";
    const std::string own = temporary_beside(file).string();  // nothing was made yet: an ended namesake's
    const std::string process = "." + std::to_string(getpid()) + ".";
    std::string of_parent = own;
    of_parent.replace(of_parent.rfind(process), process.size(), "." + std::to_string(getppid()) + ".");
    for (const std::string& name :
         {own, own + ".aB3x", of_parent, file.string(), file.string() + ".other.1.tmp", own + "x",
          temporary_beside(test.path() / "out2.zip").string()}) {
        std::ofstream{name} << "x";
    }
    std::vector<fs::path> expected{own, own + ".aB3x", own + "x"};
    std::vector<fs::path> found = leftovers_of(file);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    delete_leftovers_of(file);
    EXPECT_TRUE(leftovers_of(file).empty());
    EXPECT_TRUE(fs::exists(file));
    EXPECT_TRUE(fs::exists(of_parent));
}

}  // namespace
}  // namespace coupling::leftovers_test
