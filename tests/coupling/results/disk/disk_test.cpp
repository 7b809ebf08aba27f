#include "coupling/results/disk/disk.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "config/errors/input_error.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::disk_test {
namespace {

namespace fs = std::filesystem;
using small_runs::TestFolder;
using small_runs::text_of;

void write_letters(const fs::path& file, const std::string& letters) {
    OutFile out{file};
    out.stream() << letters;
    out.close();
}

TEST(IsThere, CountsALinkToNothing) {
    const TestFolder folder;
    fs::create_symlink("nowhere", folder.path() / "link");
    EXPECT_TRUE(is_there(folder.path() / "link"));
    EXPECT_FALSE(is_there(folder.path() / "nowhere"));
    EXPECT_FALSE(is_folder(folder.path() / "link"));
    EXPECT_TRUE(is_folder(folder.path()));
}

TEST(IsThere, TakesNothingForMissingThatItCannotExamine) {
    const TestFolder folder;
    EXPECT_THROW(is_there(folder.path() / std::string(300, 'x')), config::InputError);
    fs::create_symlink("circle", folder.path() / "circle");
    EXPECT_THROW(is_folder(folder.path() / "circle"), config::InputError);
}

TEST(LinkOrCopy, KeepsTheFirstName) {
    const TestFolder folder;
    write_letters(folder.path() / "first", "rocks\n");
    link_or_copy(folder.path() / "first", folder.path() / "second");
    fs::remove(folder.path() / "second");
    EXPECT_EQ(text_of(folder.path() / "first"), "rocks\n");
    link_or_copy(folder.path() / "first", folder.path() / "second");
    fs::remove(folder.path() / "first");
    EXPECT_EQ(text_of(folder.path() / "second"), "rocks\n");
}

TEST(LinkOrCopy, CopiesToAnotherDisk) {
    const fs::path other{"/dev/shm"};
    const TestFolder folder;
    if (!fs::is_directory(other)) {
        GTEST_SKIP() << "no second disk here";
    }
    write_letters(folder.path() / "first", "rocks\n");
    const fs::path copy = other / (folder.path().filename().string() + "-copy");
    link_or_copy(folder.path() / "first", copy);
    EXPECT_EQ(text_of(copy), "rocks\n");
    fs::remove(copy);
}

TEST(SyncAllBelow, ReachesFoldersInFolders) {
    const TestFolder folder;
    make_folder(folder.path() / "a/b");
    write_letters(folder.path() / "a/b/c", "rocks\n");
    EXPECT_NO_THROW(sync_all_below(folder.path()));
    EXPECT_THROW(sync_all_below(folder.path() / "missing"), config::InputError);
    EXPECT_THROW(sync_file(folder.path() / "missing"), config::InputError);
}

TEST(MoveEntry, NamesWhereItCannotGo) {
    const TestFolder folder;
    write_letters(folder.path() / "file", "");
    try {
        move_entry(folder.path() / "file", folder.path() / "no/such/folder");
        FAIL() << "moved";
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("no/such/folder"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace coupling::disk_test
