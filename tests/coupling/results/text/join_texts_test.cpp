#include "coupling/results/text/join_texts.hpp"

#include <gtest/gtest.h>

#include "coupling/results/text/writing_language.hpp"

namespace coupling::report::join_texts_test {
namespace {

TEST(JoinTexts, LeavesOutWhatIsEmpty) {
    EXPECT_EQ(join_sentences({"", "One.", "", "Two."}), "One. Two.");
    EXPECT_EQ(join_with_commas({"a", "", "b"}), "a, b");
    EXPECT_EQ(join_with_semicolons({"", "a"}), "a");
    EXPECT_EQ(join_with_and({}), "");
}

TEST(JoinTexts, UsesTheWordsAndBlanksOfTheLanguage) {
    EXPECT_EQ(join_with_and({"a", "b", "c"}), "a, b and c");
    EXPECT_EQ(join_with_semicolons({"a", "b", "c"}), "a; b; c");
    EXPECT_EQ(with_label("a", "b"), "a: b");
    const WritingLanguage french{config::Language::fr};
    EXPECT_EQ(join_with_and({"a", "b", "c"}), "a, b et c");
    EXPECT_EQ(join_with_semicolons({"a", "b", "c"}), "a\u202f; b\u202f; c");
    EXPECT_EQ(with_label("a", "b"), "a\u00a0: b");
}

}  // namespace
}  // namespace coupling::report::join_texts_test
