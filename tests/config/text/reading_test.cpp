#include "config/text/reading.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "config/errors/input_error.hpp"

namespace config::reading_test {
namespace {

std::string read(const std::string& bytes) {
    std::istringstream in{bytes};
    return read_text(in, "a.csv");
}

TEST(ReadText, DropsTheByteOrderMark) {
    EXPECT_EQ(read("\xEF\xBB\xBFx"), "x");
}

TEST(ReadText, RefusesUtf16AndBinaryFiles) {
    EXPECT_THROW(read(std::string{"\xFF\xFEx\0", 4}), InputError);
    EXPECT_THROW(read(std::string{"ab\0c", 4}), InputError);
}

TEST(Trimmed, TakesBlanksOffBothEnds) {
    EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
    EXPECT_EQ(trimmed(" \r\n"), "");
}

}  // namespace
}  // namespace config::reading_test
