#include "coupling/run/folder_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>

#include "config/errors/input_error.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::folder_lock_test {
namespace {

namespace fs = std::filesystem;
using small_runs::TestFolder;
using small_runs::text_of;
using Use = FolderLock::Use;

TEST(FolderLock, RefusesASecondRun) {
    const TestFolder folder;
    const fs::path file = folder.path() / "mark";
    const FolderLock first{file, Use::alone};
    EXPECT_TRUE(first.is_alone());
    EXPECT_TRUE(first.made_file());
    try {
        const FolderLock second{file, Use::alone};
        FAIL() << "two at once";
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::settings);
        EXPECT_NE(std::string{error.what()}.find("another run of bannwald works"), std::string::npos);
    }
}

TEST(FolderLock, IsFreeOnceTheFirstHasEnded) {
    const TestFolder folder;
    { const FolderLock first{folder.path() / "mark", Use::alone}; }
    const FolderLock second{folder.path() / "mark", Use::alone};
    EXPECT_FALSE(second.made_file());
}

TEST(FolderLock, EndsWithAProcessThatIsKilled) {
    const TestFolder folder;
    const fs::path file = folder.path() / "mark";
    int has_lock[2] = {};
    ASSERT_EQ(pipe(has_lock), 0);
    const pid_t child = fork();
    if (child == 0) {
        const FolderLock lock{file, Use::alone};
        [[maybe_unused]] const auto said = write(has_lock[1], "x", 1);
        pause();
        _exit(0);
    }
    char said = 0;
    ASSERT_EQ(read(has_lock[0], &said, 1), 1);
    EXPECT_THROW((FolderLock{file, Use::alone}), config::InputError);
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_NO_THROW((FolderLock{file, Use::alone}));
    close(has_lock[0]);
    close(has_lock[1]);
}

TEST(FolderLock, LetsShardsInBesideEachOther) {
    const TestFolder folder;
    const fs::path file = folder.path() / "mark";
    std::optional<FolderLock> first{std::in_place, file, Use::shared};
    EXPECT_TRUE(first->is_alone());  // to prepare the folder
    first->share();
    FolderLock second{file, Use::shared};
    EXPECT_FALSE(second.is_alone());
    EXPECT_FALSE(second.try_alone());
    EXPECT_THROW((FolderLock{file, Use::alone}), config::InputError);
    // try_alone gives up the lock where it fails, so it comes last in the life of a run.
    first.reset();
    FolderLock third{file, Use::shared};
    EXPECT_TRUE(third.is_alone());
}

TEST(FolderLock, HoldsItsTextThroughRewriting) {
    const TestFolder folder;
    FolderLock lock{folder.path() / "mark", Use::alone};
    EXPECT_EQ(lock.text(), "");
    lock.write_text(std::string(10'000, 'x'));
    EXPECT_EQ(lock.text(), std::string(10'000, 'x'));
    lock.write_text("short\n");
    EXPECT_EQ(lock.text(), "short\n");
    EXPECT_EQ(text_of(folder.path() / "mark"), "short\n");
}

TEST(FolderLock, FollowsNoSymbolicLink) {
    const TestFolder folder;
    std::ofstream{folder.path() / "mine"} << "my own work\n";
    fs::create_symlink("mine", folder.path() / "mark");
    try {
        const FolderLock lock{folder.path() / "mark", Use::alone};
        FAIL() << "followed";
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("symbolic link"), std::string::npos) << error.what();
    }
    EXPECT_EQ(text_of(folder.path() / "mine"), "my own work\n");
}

}  // namespace
}  // namespace coupling::folder_lock_test
