#include "config/text/words_of_list.hpp"

#include <gtest/gtest.h>

namespace config::words_of_list_test {
namespace {

using Words = std::vector<std::string>;

TEST(WordsOfList, AreWhatStandsBetweenTheCommas) {
    EXPECT_EQ(words_of_list("plate,cube"), (Words{"plate", "cube"}));
    EXPECT_EQ(words_of_list(" plate , cube"), (Words{"plate", "cube"}));
    EXPECT_EQ(words_of_list("plate,"), (Words{"plate", ""}));
    EXPECT_EQ(words_of_list(""), (Words{""}));
}

TEST(WordsBetweenBlanks, AreNoneWhereThereAreOnlyBlanks) {
    EXPECT_EQ(words_between_blanks(" 1  2\t3 "), (Words{"1", "2", "3"}));
    EXPECT_EQ(words_between_blanks("1,2"), (Words{"1,2"}));
    EXPECT_EQ(words_between_blanks("  "), Words{});
}

}  // namespace
}  // namespace config::words_of_list_test
