#include "config/text/language.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <string>

namespace config {
namespace {

constexpr std::array all_languages{Language::en, Language::de,    Language::fr,
                                   Language::it, Language::de_CH, Language::fr_CH};

TEST(NumbersForPeople, HaveTheDecimalSignOfTheLanguageAndNarrowBlanksBetweenThousands) {
    EXPECT_EQ(for_people("1234567.125", Language::en), "1\u202f234\u202f567.125");
    for (const Language language : {Language::de, Language::fr, Language::it}) {
        EXPECT_EQ(for_people("1234567.125", language), "1\u202f234\u202f567,125");
    }
    EXPECT_EQ(for_people("1234567.125", Language::de_CH), "1\u2019234\u2019567.125");
    EXPECT_EQ(for_people("1234567.125", Language::fr_CH), "1\u2019234\u2019567.125");
    EXPECT_EQ(for_people("-12", Language::de), "\u221212");
    EXPECT_EQ(for_people("-1000", Language::fr), "\u22121\u202f000");
    EXPECT_EQ(for_people("100", Language::it), "100");
}

/// What a program could read again.
std::string for_machines(std::string text, Language language) {
    const auto exchange = [&](const std::string& from, const std::string& to) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from)) {
            text.replace(at, from.size(), to);
        }
    };
    exchange("\u202f", "");
    exchange("\u2019", "");
    exchange("\u2212", "-");
    if (decimal_sign(language) == ',') {
        exchange(",", ".");
    }
    return text;
}

TEST(NumbersForPeople, LoseNoDigit) {
    rc::check([](int whole, std::uint16_t part) {
        const std::string number = std::to_string(whole) + "." + std::to_string(part);
        for (const Language language : all_languages) {
            RC_ASSERT(for_machines(for_people(number, language), language) == number);
        }
    });
}

TEST(Dates, AreReadInBothWaysAndWrittenAsTheLanguageDoes) {
    const Date day{2026, 11, 4};
    EXPECT_EQ(parse_date("2026-11-04"), day);
    EXPECT_EQ(parse_date("4.11.2026"), day);
    EXPECT_EQ(for_people(day, Language::en), "4 November 2026");
    for (const Language language : {Language::de, Language::fr, Language::it}) {
        EXPECT_EQ(for_people(day, language), "04.11.2026");
    }
}

TEST(Dates, ExistInTheCalendar) {
    EXPECT_TRUE(parse_date("2024-02-29"));
    EXPECT_TRUE(parse_date("2000-02-29"));
    for (const char* wrong :
         {"2026-02-29", "1900-02-29", "2026-13-01", "2026-00-01", "2026-04-31", "31.4.2026", "2026-11",
          "24.11.26", "11/24/2026", "today", "", "2026-11-24T00", "--", "..", "2026--1-01", "+1.1.2026"}) {
        EXPECT_FALSE(parse_date(wrong)) << wrong;
    }
}

TEST(Languages, AreNamedByTheirTags) {
    for (const Language language : all_languages) {
        EXPECT_EQ(language_of(tag_of(language)), language);
    }
    EXPECT_EQ(language_of("de_CH"), Language::de_CH);  // as settings have it
    EXPECT_EQ(language_of("fr_CH"), Language::fr_CH);
    EXPECT_FALSE(language_of("rm"));
    EXPECT_FALSE(language_of("DE"));
}

}  // namespace
}  // namespace config
