#include "coupling/results/text/page_text.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "coupling/results/text/catalogue.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::report::page_text_test {
namespace {

TEST(PageText, IsThatOfTheLanguageInUse) {
    EXPECT_EQ(page_text("with forest"), "with forest");
    const WritingLanguage german{config::Language::de};
    EXPECT_EQ(page_text("with forest"), "mit Wald");
}

TEST(PageText, IsGermanWithDoubleSInSwitzerland) {
    std::size_t changed = 0;
    for (const std::string& english : english_page_texts()) {
        std::string german;
        {
            const WritingLanguage of_germany{config::Language::de};
            german = page_text(english);
        }
        const WritingLanguage swiss{config::Language::de_CH};
        EXPECT_EQ(page_text(english).find("ß"), std::string::npos) << english;
        EXPECT_EQ(page_text(english), with_double_s(german));
        changed += page_text(english) == german ? 0 : 1;
    }
    EXPECT_GT(changed, 10U);
}

TEST(PageText, PutsValuesInThePlaceOfTheirNames) {
    EXPECT_EQ(page_text("year {year}", {{"year", "12"}}), "year 12");
    EXPECT_EQ(
        page_text("{interval_low} to {interval_high}", {{"interval_high", "9 %"}, {"interval_low", "3 %"}}),
        "3 % to 9 %");
}

TEST(PageText, RefusesWhatTheTableDoesNotHave) {
    EXPECT_THROW(page_text("no such text"), std::logic_error);
    EXPECT_THROW(page_text("year {year}", {{"month", "12"}}), std::logic_error);
    EXPECT_THROW(page_text("year {year}", {}), std::logic_error);
    EXPECT_THROW(page_text("with forest", {{"year", "12"}}), std::logic_error);
}

}  // namespace
}  // namespace coupling::report::page_text_test
