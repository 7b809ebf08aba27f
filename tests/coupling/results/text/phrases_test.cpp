#include "coupling/results/text/phrases.hpp"

#include <gtest/gtest.h>

#include "coupling/results/text/writing_language.hpp"

namespace coupling::report::phrases_test {
namespace {

TEST(InPageLanguage, SaysTheGroundsOfTheExamples) {
    const WritingLanguage german{config::Language::de};
    EXPECT_EQ(in_page_language("talus below a rock face"), "Schutthalde unter einer Felswand");
    EXPECT_EQ(in_page_language("forest road"), "Forststraße");
}

/// A name of a user that holds a phrase within a word stays as it is, and one with a word of everyday use.
TEST(InPageLanguage, LeavesPartsOfOtherWords) {
    const WritingLanguage german{config::Language::de};
    for (const char* name : {"roadside", "rail road", "wet scree", "Äpasture", "forest roads", "pastures"}) {
        EXPECT_EQ(in_page_language(name), name);
    }
    EXPECT_EQ(in_page_language("rock face, valley floor"), "Felswand, Talboden");
}

}  // namespace
}  // namespace coupling::report::phrases_test
