#include "coupling/run/staged_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "coupling/results/disk/byte_archive.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::staged_folder_test {
namespace {

namespace fs = std::filesystem;
using testing::TestFolder;
using testing::text_of;

void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream{file} << text;
}

std::ptrdiff_t entries_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator{folder}, fs::directory_iterator{});
}

/// The number of a process that has ended.
pid_t ended_process() {
    const pid_t process = fork();
    if (process == 0) {
        _exit(0);
    }
    waitpid(process, nullptr, 0);
    return process;
}

/// The temporary name that another process gives.
fs::path temporary_of(const fs::path& file, pid_t process) {
    std::string name = temporary_beside(file).string();
    const std::string own = "." + std::to_string(getpid()) + ".";
    return name.replace(name.rfind(own), own.size(), "." + std::to_string(process) + ".");
}

TEST(StagedFolder, PutsAllFilesInTheirPlaceAtOnce) {
    const TestFolder test;
    const fs::path folder = test.path() / "new";
    StagedFolder staged{folder};
    put(staged.path() / "one.csv", "1");
    put(staged.path() / "two.csv", "2");
    EXPECT_FALSE(fs::exists(folder / "one.csv"));
    staged.publish();
    EXPECT_EQ(text_of(folder / "one.csv"), "1");
    EXPECT_EQ(text_of(folder / "two.csv"), "2");
    EXPECT_EQ(entries_in(folder), 2);
}

TEST(StagedFolder, LeavesNothingWithoutBeingPublished) {
    const TestFolder test;
    {
        StagedFolder staged{test.path() / "new"};
        put(staged.path() / "one.csv", "1");
    }
    EXPECT_EQ(entries_in(test.path()), 0);
}

TEST(StagedFolder, FinishesWhatWasOnItsWayAndDeletesWhatWasNot) {
    const TestFolder test;
    put(test.path() / "one.csv", "old");
    put(test.path() / ".staged_whole" / "one.csv", "new");
    put(test.path() / ".staged_whole" / "two.csv", "new too");
    const fs::path left = temporary_of(test.path() / ".staged", ended_process());
    const fs::path at_work = temporary_of(test.path() / ".staged", getppid());
    put(left / "half.csv", "ha");
    put(at_work / "half.csv", "ha");
    StagedFolder::tidy(test.path());
    EXPECT_EQ(text_of(test.path() / "one.csv"), "new");
    EXPECT_EQ(text_of(test.path() / "two.csv"), "new too");
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(at_work)) << "another process is at work there";
    EXPECT_EQ(entries_in(test.path()), 3);
}

}  // namespace
}  // namespace coupling::staged_folder_test
