#include "coupling/results/text/page_text.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>
#include <string>

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
        EXPECT_EQ(page_text(english), swiss_german(german));
        changed += page_text(english) == german ? 0 : 1;
    }
    EXPECT_GT(changed, 10U);
}

TEST(PageText, HasPointsInNumbersInSwitzerlandAndCommasInLists) {
    EXPECT_EQ(swiss_german("das 0,82-Fache, 1,28 H^1,085"), "das 0.82-Fache, 1.28 H^1.085");
    EXPECT_EQ(swiss_german("--distances 0,10,20; 1, 2"), "--distances 0,10,20; 1, 2");
    EXPECT_EQ(swiss_german("groß,3"), "gross,3");
}

TEST(PageText, IsFrenchWithTheTermsOfSwitzerlandThere) {
    // France has aléa, niveau and enjeu, Switzerland danger, degré and objet: no page has both.
    const std::regex of_france{"(^|[^a-z])([Aa]léas?|[Ee]njeux?)([^a-z\\xC3]|$)"};
    const std::regex of_switzerland{"(^|[^a-z])([Dd]angers?|[Oo]bjets?)([^a-z\\xC3]|$)"};
    std::size_t changed = 0;
    for (const std::string& english : english_page_texts()) {
        std::string french;
        {
            const WritingLanguage here{config::Language::fr};
            french = page_text(english);
        }
        const WritingLanguage swiss{config::Language::fr_CH};
        EXPECT_FALSE(std::regex_search(french, of_switzerland)) << french;
        EXPECT_FALSE(std::regex_search(page_text(english), of_france)) << page_text(english);
        EXPECT_EQ(page_text(english), with_swiss_terms(french));
        changed += page_text(english) == french ? 0 : 1;
    }
    EXPECT_GT(changed, 100U);
    EXPECT_EQ(with_swiss_terms("Le niveau d’aléa à l’enjeu, des niveaux de l’aléa, un tirage aléatoire"),
              "Le degré de danger à l’objet, des degrés du danger, un tirage aléatoire");
    EXPECT_EQ(with_swiss_terms("Courbes de niveau tous les 10 m"), "Courbes de niveau tous les 10 m");
}

TEST(PageText, PutsValuesInThePlaceOfTheirNames) {
    EXPECT_EQ(page_text("year {year}", {{"year", "12"}}), "year 12");
    EXPECT_EQ(
        page_text("{interval_low} to {interval_high}", {{"interval_high", "9 %"}, {"interval_low", "3 %"}}),
        "3 % to 9 %");
}

TEST(PageText, HasWordsOfOne) {
    constexpr const char* closed =
        "Each block that hits closes the road for {closure_days} days, at {closure_cost} a day; nobody is "
        "hit "
        "less for that.";
    const auto words = [&](const char* days) {
        return page_text(closed, {{"closure_days", days}, {"closure_cost", "3"}});
    };
    EXPECT_NE(words("1").find(" 1 day,"), std::string::npos) << words("1");
    EXPECT_NE(words("0.5").find(" 0.5 days,"), std::string::npos) << words("0.5");
    EXPECT_EQ(with_many("{a} {a?stone|stones}, {b}"), "{a} stones, {b}");
    EXPECT_THROW(with_many("{a?stone}"), std::logic_error);
    {
        const WritingLanguage german{config::Language::de};
        EXPECT_NE(words("1").find("für 1 Tag,"), std::string::npos) << words("1");
        EXPECT_NE(words("21").find("für 21 Tage,"), std::string::npos) << words("21");
    }
    const WritingLanguage french{config::Language::fr};
    EXPECT_NE(words("0,5").find("0,5 jour,"), std::string::npos) << words("0,5");
    EXPECT_NE(words("2").find("2 jours,"), std::string::npos) << words("2");
}

TEST(PageText, RefusesWhatTheTableDoesNotHave) {
    EXPECT_THROW(page_text("no such text"), std::logic_error);
    EXPECT_THROW(page_text("year {year}", {{"month", "12"}}), std::logic_error);
    EXPECT_THROW(page_text("year {year}", {}), std::logic_error);
    EXPECT_THROW(page_text("with forest", {{"year", "12"}}), std::logic_error);
}

}  // namespace
}  // namespace coupling::report::page_text_test
