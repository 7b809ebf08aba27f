#include "coupling/results/disk/byte_archive.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "tests/coupling/results/small_run.hpp"

namespace coupling::byte_archive_test {
namespace {

namespace fs = std::filesystem;
using small_runs::TestFolder;
using small_runs::text_of;

fs::path written_archive(const fs::path& folder) {
    const fs::path file = folder / "archive.part";
    const fs::path temporary = temporary_beside(file);
    ByteWriter out{temporary};
    out.text("who it is");
    out.list(std::vector<double>{1.0, 2.0, 3.0});
    close_and_rename(out, temporary, file);
    return file;
}

void read_archive(const fs::path& file) {
    ByteReader in{file};
    in.check_whole();
    EXPECT_EQ(in.text(), "who it is");
    EXPECT_EQ(in.list<double>(), (std::vector<double>{1.0, 2.0, 3.0}));
    in.check_end();
}

TEST(ByteArchive, ComesBackAsItWasAndLeavesNoOtherFile) {
    const TestFolder folder;
    read_archive(written_archive(folder.path()));
    EXPECT_EQ(std::distance(fs::directory_iterator{folder.path()}, fs::directory_iterator{}), 1);
}

// Bytes between the members of a struct are left over from whatever stood there.
TEST(ByteArchive, OfTheSameValuesIsTheSameFile) {
    struct Row {
        std::int32_t year;
        double value;
        bool holds;
    };
    const TestFolder folder;
    std::vector<std::string> files;
    for (const int garbage : {0x00, 0xAB}) {
        std::vector<Row> rows(3);
        std::memset(static_cast<void*>(rows.data()), garbage, rows.size() * sizeof(Row));
        for (Row& row : rows) {
            row.year = 7;
            row.value = 0.5;
            row.holds = true;
        }
        ByteWriter out{folder.path() / "rows.part"};
        out.value(rows.front());
        out.list(rows);
        out.close();
        files.push_back(text_of(folder.path() / "rows.part"));
    }
    EXPECT_EQ(files[0], files[1]);
}

TEST(ByteArchive, IsRefusedWithOneOrTwoFlippedBitsBeforeAnythingIsUsed) {
    const TestFolder folder;
    const fs::path file = written_archive(folder.path());
    const std::string whole = text_of(file);
    const auto refused = [&](std::initializer_list<std::size_t> bits) {
        std::string damaged = whole;
        for (const std::size_t bit : bits) {
            damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        }
        std::ofstream{file, std::ios::binary} << damaged;
        ByteReader in{file};
        EXPECT_THROW(in.check_whole(), config::InputError);
    };
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        refused({bit});
        // Bit 63 of two words: a sum of words by a product does not see it.
        if (bit % 64 == 63 && bit + 64 < 8 * whole.size()) {
            refused({bit, bit + 64});
        }
    }
}

TEST(ByteArchive, IsRefusedAtAnyShorterLength) {
    const TestFolder folder;
    const fs::path file = written_archive(folder.path());
    for (std::uintmax_t bytes = fs::file_size(file); bytes-- > 0;) {
        fs::resize_file(file, bytes);
        ByteReader in{file};
        EXPECT_THROW(in.check_whole(), config::InputError) << bytes;
    }
}

TEST(ByteArchive, AdvisesWhatItIsTold) {
    const TestFolder folder;
    const fs::path file = written_archive(folder.path());
    fs::resize_file(file, 20);
    try {
        ByteReader in{file, "copy it once more"};
        in.check_whole();
        FAIL() << "whole";
    } catch (const config::InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("copy it once more"), std::string::npos) << error.what();
        EXPECT_EQ(std::string{error.what()}.find("delete"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace coupling::byte_archive_test
