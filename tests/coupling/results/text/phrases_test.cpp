#include "coupling/results/text/phrases.hpp"

#include <gtest/gtest.h>

#include "coupling/results/text/writing_language.hpp"

namespace coupling::report::phrases_test {
namespace {

TEST(InPageLanguage, SaysTheGroundsOfTheExamples) {
    const WritingLanguage german{config::Language::de};
    EXPECT_EQ(in_page_language("talus below a rock face"), "Schutthalde unter einer Felswand");
    EXPECT_EQ(in_page_language("road"), "Straße");
    EXPECT_EQ(in_page_language("forest road"), "Forststraße");
}

/// A name of a user that holds a phrase within a word stays as it is.
TEST(InPageLanguage, LeavesPartsOfOtherWords) {
    const WritingLanguage german{config::Language::de};
    for (const char* name :
         {"roadside", "broad", "screed", "railroad", "Äscree", "forest roads", "pastures"}) {
        EXPECT_EQ(in_page_language(name), name);
    }
    EXPECT_EQ(in_page_language("road, scree"), "Straße, Hangschutt");
}

}  // namespace
}  // namespace coupling::report::phrases_test
