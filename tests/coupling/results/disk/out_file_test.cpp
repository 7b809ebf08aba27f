#include "coupling/results/disk/out_file.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::out_file_test {
namespace {

using config::ExitCode;
using config::InputError;
using small_runs::TestFolder;

TEST(OutFile, HoldsWhatWasWritten) {
    const TestFolder folder;
    OutFile file{folder.path() / "a.txt"};
    file.stream() << "rocks\n";
    file.close();
    EXPECT_EQ(small_runs::text_of(folder.path() / "a.txt"), "rocks\n");
}

TEST(OutFile, NamesTheFileThatCannotBeOpened) {
    const TestFolder folder;
    const std::filesystem::path file = folder.path() / "missing" / "a.txt";
    try {
        const OutFile out{file};
        FAIL() << "opened";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), ExitCode::file);
        EXPECT_EQ(error.problems().front().place.file, file.string());
    }
}

TEST(OutFile, TellsOfAFullDiskAtTheLatestOnClosing) {
    if (!std::filesystem::exists("/dev/full")) {
        GTEST_SKIP() << "no /dev/full here";
    }
    OutFile file{"/dev/full"};
    file.stream() << "a few bytes that stay in the buffer\n";
    try {
        file.close();
        FAIL() << "closed";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("/dev/full"), std::string::npos);
        EXPECT_NE(std::string{error.what()}.find("No space left"), std::string::npos) << error.what();
    }
}

TEST(OutFile, TellsOfAFullDiskWhileMuchIsWritten) {
    if (!std::filesystem::exists("/dev/full")) {
        GTEST_SKIP() << "no /dev/full here";
    }
    OutFile file{"/dev/full"};
    const std::string much(1 << 20, 'x');
    file.stream() << much;
    EXPECT_THROW(file.check(), InputError);
}

TEST(OutFile, KeepsTheChecksumOfAllItsBytes) {
    const TestFolder folder;
    const std::string much(700'000, 'x');
    OutFile file{folder.path() / "table"};
    file.keep_sum({});
    file.stream() << much << "the first part\n";
    file.sync();
    Checksum expected;
    expected.add(much.data(), much.size());
    expected.add("the first part\n", 15);
    EXPECT_EQ(file.sum(), expected.value());
    file.close();

    OutFile again{folder.path() / "table", OutFile::Begin::at_end};
    again.keep_sum(Checksum{expected.value()});
    again.stream() << "the second\n";
    again.flush();
    expected.add("the second\n", 11);
    EXPECT_EQ(again.sum(), expected.value());
    EXPECT_EQ(std::filesystem::file_size(folder.path() / "table"), much.size() + 26);
}

TEST(OutFile, CountsBytesAndRowsOfATableAlsoWhereItGoesOn) {
    const TestFolder folder;
    TableEnd end;
    {
        OutFile file{folder.path() / "table.csv"};
        file.count_table();
        file.stream() << "name,x\n\"two\nlines\",1\n";
        file.close();
        end = file.end().value();
        EXPECT_EQ(end.bytes, 21U);
        EXPECT_EQ(end.rows, 1U);
    }
    OutFile again{folder.path() / "table.csv", OutFile::Begin::at_end};
    EXPECT_FALSE(again.end());
    again.count_table(end);
    again.stream() << "road,2\n";
    again.close();
    EXPECT_EQ(again.end()->bytes, std::filesystem::file_size(folder.path() / "table.csv"));
    EXPECT_EQ(again.end()->rows, 2U);
}

TEST(MakeFolder, NamesTheFolderThatCannotBeMade) {
    const TestFolder folder;
    OutFile file{folder.path() / "taken"};
    file.close();
    EXPECT_THROW(make_folder(folder.path() / "taken" / "below"), InputError);
}

}  // namespace
}  // namespace coupling::out_file_test
