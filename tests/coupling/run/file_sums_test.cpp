#include "coupling/run/file_sums.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::file_sums_test {
namespace {

namespace fs = std::filesystem;
using small_runs::put;
using small_runs::TestFolder;
using small_runs::text_of;

TEST(FileSums, NoticeEachChangedBitAndEachMissingFile) {
    const TestFolder test;
    put(test.path() / "tables/rocks.csv", "a,b\n1,2\n");
    put(test.path() / "tables/a name with blanks.csv", "a\n");
    put(test.path() / "summary.json", "{}");
    write_sums(test.path());
    EXPECT_EQ(changed_file(test.path()), "");
    const std::string whole = text_of(test.path() / "tables/rocks.csv");
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string damaged = whole;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        put(test.path() / "tables/rocks.csv", damaged);
        EXPECT_EQ(changed_file(test.path()), "tables/rocks.csv has changed") << bit;
        EXPECT_THROW(refuse_changed(test.path(), "tables/rocks.csv"), config::InputError);
        EXPECT_NO_THROW(refuse_changed(test.path(), "summary.json"));
    }
    put(test.path() / "tables/rocks.csv", whole + "3,4\n");
    EXPECT_EQ(changed_file(test.path()), "tables/rocks.csv has changed");
    put(test.path() / "tables/rocks.csv", whole);
    EXPECT_EQ(changed_file(test.path()), "");
    fs::remove(test.path() / "tables/a name with blanks.csv");
    EXPECT_EQ(changed_file(test.path()), "tables/a name with blanks.csv is missing");
    EXPECT_THROW(refuse_changed(test.path(), "tables/a name with blanks.csv"), config::InputError);
    EXPECT_NO_THROW(refuse_changed(test.path(), "tables/never written.csv"));
}

TEST(FileSums, AreNotAskedForOfResultsWithoutThem) {
    const TestFolder test;
    put(test.path() / "summary.json", "{}");
    EXPECT_NO_THROW(refuse_changed(test.path(), "summary.json"));
    EXPECT_EQ(changed_file(test.path()), ".checksums is missing");
}

}  // namespace
}  // namespace coupling::file_sums_test
