#include "config/text/encoding.hpp"

#include <gtest/gtest.h>

namespace config::encoding_test {
namespace {

TEST(IsUtf8, TakesLettersOfOneToFourBytes) {
    EXPECT_TRUE(is_utf8(""));
    EXPECT_TRUE(is_utf8("Fichte"));
    EXPECT_TRUE(is_utf8("F\u00F6hre \u20AC \U0001F332"));
}

TEST(IsUtf8, RefusesWhatNoLetterHas) {
    for (const char* text : {"F\xF6hre", "\xC3", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80",
                             "\xF5\x80\x80\x80", "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\x80"}) {
        EXPECT_FALSE(is_utf8(text)) << text;
    }
}

TEST(ToUtf8, KnowsTheLettersOfWindows) {
    EXPECT_EQ(to_utf8("F\xF6hre", Encoding::unknown), "Föhre");
    EXPECT_EQ(to_utf8("\x80 \x96 \xDF", Encoding::windows_1252), "€ – ß");
    EXPECT_EQ(to_utf8("Föhre", Encoding::unknown), "Föhre");
    EXPECT_EQ(to_utf8("Föhre", Encoding::utf_8), "Föhre");
}

TEST(ToUtf8, GivesUtf8OfAllBytes) {
    for (int byte = 0; byte < 256; ++byte) {
        EXPECT_TRUE(is_utf8(to_utf8(std::string(1, static_cast<char>(byte)), Encoding::windows_1252)))
            << byte;
    }
}

TEST(EncodingNamed, KnowsWhatFilesCallIt) {
    for (const char* name : {"UTF-8", "utf8", "65001"}) {
        EXPECT_EQ(encoding_named(name), Encoding::utf_8) << name;
    }
    for (const char* name : {"1252", "CP1252", "ISO-8859-1", "ISO 88591", "ANSI 1252"}) {
        EXPECT_EQ(encoding_named(name), Encoding::windows_1252) << name;
    }
    EXPECT_EQ(encoding_named("Big5"), std::nullopt);
}

}  // namespace
}  // namespace config::encoding_test
