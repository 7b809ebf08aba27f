#include "config/text/gunzip.hpp"

#include <gtest/gtest.h>

#include "config/errors/input_error.hpp"

namespace config::gunzip_test {
namespace {

/// `printf 'ncols 3\nnrows 2\n' | gzip -9n`
const std::string packed{
    "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\xcb\x4b\xce\xcf\x29\x56\x30\xe6\xca\x2b\xca\x2f\x2f\x56\x30\xe2"
    "\x02"
    "\x00\xc9\x2e\x3d\x6b\x10\x00\x00\x00",
    36};

std::string message_of(const std::string& bytes) {
    try {
        gunzip(bytes, "dem.asc.gz");
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), ExitCode::file);
        return error.what();
    }
    return "";
}

TEST(Gunzip, UnpacksOneMemberOrMore) {
    EXPECT_TRUE(is_gzip(packed));
    EXPECT_EQ(gunzip(packed, "a.gz"), "ncols 3\nnrows 2\n");
    EXPECT_EQ(gunzip(packed + packed, "a.gz"), "ncols 3\nnrows 2\nncols 3\nnrows 2\n");
}

TEST(Gunzip, RefusesAFileCutOffAnywhere) {
    for (std::size_t size = 2; size < packed.size(); ++size) {
        EXPECT_EQ(
            message_of(packed.substr(0, size)),
            "dem.asc.gz: found a gzip file that is cut off or broken, expected a whole one: copy it again")
            << size << " bytes";
    }
}

TEST(Gunzip, RefusesAContentThatDoesNotMatchItsChecksum) {
    std::string broken = packed;
    broken[28] = static_cast<char>(broken[28] ^ 1);
    EXPECT_NE(message_of(broken), "");
}

TEST(Gunzip, RefusesMoreThanTheBoundThatTheBeginningSets) {
    std::string seen;
    const auto bound = [&](std::uint64_t bytes) {
        return [&seen, bytes](std::string_view beginning) {
            seen = beginning;
            return bytes;
        };
    };
    EXPECT_EQ(gunzip(packed, "a.gz", bound(16)), "ncols 3\nnrows 2\n");
    EXPECT_EQ(seen, "ncols 3\nnrows 2\n");
    try {
        gunzip(packed, "a.gz", bound(15));
        ADD_FAILURE() << "taken";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), ExitCode::data);
        EXPECT_TRUE(
            std::string{error.what()}.starts_with("a.gz: found a gzip file that holds more than 1 MB"))
            << error.what();
    }
}

TEST(Gunzip, RefusesWhatIsNotGzip) {
    EXPECT_FALSE(is_gzip("ncols 3"));
    EXPECT_FALSE(is_gzip(""));
    EXPECT_EQ(message_of("ncols 3"), "dem.asc.gz: found another beginning, expected a gzip file");
}

}  // namespace
}  // namespace config::gunzip_test
