#include "coupling/results/figures/few_rocks.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "config/text/language.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::few_rocks_test {
namespace {

TEST(TooFewForProtection, AsksOnlyForArrivalsOverTheBareSlope) {
    EXPECT_TRUE(too_few_for_protection({.both = 1, .only_forest = 100, .only_bare = 3}));
    EXPECT_FALSE(too_few_for_protection({.both = 0, .only_forest = 0, .only_bare = 5}));
}

TEST(TooFewInWords, CountsTheRocks) {
    EXPECT_EQ(too_few_in_words(0), "no rock arrives over the bare slope: too few for a protection figure");
    EXPECT_EQ(too_few_in_words(1),
              "only 1 rock arrives over the bare slope: too few for a protection figure");
    EXPECT_EQ(too_few_in_words(2),
              "only 2 rocks arrive over the bare slope: too few for a protection figure");
}

TEST(TooFewInWords, OfAnEnglishRunAreTheSameInTheLanguageOfAComparison) {
    for (const config::Language language :
         {config::Language::de, config::Language::fr, config::Language::it}) {
        for (const std::uint64_t rocks : {0, 1, 4}) {
            const std::string english = too_few_in_words(rocks);
            const report::WritingLanguage writing{language};
            EXPECT_EQ(report::message_text(english), too_few_in_words(rocks)) << english;
        }
    }
}

}  // namespace
}  // namespace coupling::few_rocks_test
