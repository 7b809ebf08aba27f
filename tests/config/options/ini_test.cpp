#include "config/options/ini.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace config::ini_test {
namespace {

std::vector<IniEntry> entries_of(const std::string& text, Problems& problems) {
    std::istringstream in{text};
    return read_ini(in, "run.ini", problems);
}

std::string only_value_of(const std::string& text) {
    Problems problems;
    const std::vector<IniEntry> entries = entries_of(text, problems);
    return entries.size() == 1 && problems.empty() ? entries[0].value : "not one assignment";
}

TEST(ReadIni, KnowsSectionNameValueAndPlaces) {
    Problems problems;
    const std::vector<IniEntry> entries =
        entries_of("\xEF\xBB\xBFyears = 3\r\n[run]\r\n\r\n  seed=7 ; why not\r\n", problems);
    EXPECT_TRUE(problems.empty());
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].key(), "years");
    EXPECT_EQ(entries[1].key(), "run.seed");
    EXPECT_EQ(entries[1].value, "7");
    EXPECT_EQ(entries[1].key_place.line, 4U);
    EXPECT_EQ(entries[1].key_place.column, 3U);
    EXPECT_EQ(entries[1].value_place.column, 8U);
}

TEST(ReadIni, TakesCommentsOffAfterABlank) {
    EXPECT_EQ(only_value_of("# a = 1\n; b = 2\na = 50 # years\n"), "50");
    EXPECT_EQ(only_value_of("a = 50 ;years\n"), "50");
    EXPECT_EQ(only_value_of("a = dem#2;b.asc\n"), "dem#2;b.asc");
    EXPECT_EQ(only_value_of("a = # nothing\n"), "");
}

TEST(ReadIni, KeepsWhatStandsInQuotes) {
    EXPECT_EQ(only_value_of("a = \" x # y ; z \" # note\n"), " x # y ; z ");
    EXPECT_EQ(only_value_of("a = \"5\"\" pipe\"\n"), "5\" pipe");
    EXPECT_EQ(only_value_of("a = 5\" pipe ; note\n"), "5\" pipe");
    EXPECT_EQ(only_value_of("a = \"\"\n"), "");
    EXPECT_EQ(only_value_of("a = b = c\n"), "b = c");
}

TEST(ReadIni, RefusesUtf16) {
    Problems problems;
    try {
        entries_of("\xFF\xFEx", problems);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), ExitCode::settings);
    }
}

TEST(ReadIni, RefusesAFileThatIsTooLongForSettings) {
    Problems problems;
    std::istringstream longest{"a = 1\n#" + std::string(longest_ini_bytes - 7, 'x')};
    EXPECT_EQ(read_ini(longest, "s.ini", problems).size(), 1U);
    EXPECT_TRUE(problems.empty());
    std::istringstream longer{"a = 1\n#" + std::string(longest_ini_bytes - 6, 'x')};
    EXPECT_THROW(read_ini(longer, "s.ini", problems), InputError);
}

TEST(ReadIni, EndsAfterAHundredLinesThatAreNone) {
    std::string text;
    for (int line = 0; line < 300; ++line) {
        text += "some words\n";
    }
    Problems problems;
    std::istringstream in{text};
    EXPECT_TRUE(read_ini(in, "s.ini", problems).empty());
    EXPECT_EQ(problems.list().size(), most_ini_problems);
}

TEST(ReadOverride, CutsAtTheLastDotBeforeTheFirstEqualsSign) {
    Problems problems;
    const std::vector<IniEntry> entries = read_override("regime:a.b.name=x=y", problems);
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].section, "regime:a.b");
    EXPECT_EQ(entries[0].name, "name");
    EXPECT_EQ(entries[0].value, "x=y");
}

}  // namespace
}  // namespace config::ini_test
