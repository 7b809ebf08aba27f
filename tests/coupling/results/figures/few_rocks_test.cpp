#include "coupling/results/figures/few_rocks.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "config/text/language.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::few_rocks_test {
namespace {

TEST(TooFewForProtection, AsksFirstForArrivalsOverTheBareSlope) {
    EXPECT_TRUE(too_few_for_protection({.both = 1, .only_forest = 100, .only_bare = 3}));
    EXPECT_FALSE(too_few_for_protection({.both = 0, .only_forest = 0, .only_bare = 5}));
}

TEST(TooFewForProtection, LeavesNoIntervalThatHoldsZeroAndReachesBeyondAHundredPercent) {
    for (std::uint64_t both = 0; both < 12; ++both) {
        for (std::uint64_t only_forest = 0; only_forest < 12; ++only_forest) {
            for (std::uint64_t only_bare = 0; only_bare < 12; ++only_bare) {
                const PairedCounts counts{both, only_forest, only_bare};
                const auto effect = protection_effect(counts);
                if (effect && !too_few_for_protection(counts)) {
                    EXPECT_TRUE(effect->interval.low > 0.0 || effect->interval.high < 0.0 ||
                                (effect->interval.low >= -1.0 && effect->interval.high <= 1.0))
                        << both << " " << only_forest << " " << only_bare;
                }
            }
        }
    }
}

TEST(TooFewForProtection, KeepsAForestThatDoublesWhatArrives) {
    EXPECT_FALSE(too_few_for_protection({.both = 100, .only_forest = 150, .only_bare = 5}));
}

TEST(SaysNothing, OfTwoReplicatesThatDisagree) {
    EXPECT_TRUE(says_nothing(-704.3, 601.6));
    EXPECT_TRUE(says_nothing(-143.8, 100.0));
    EXPECT_FALSE(says_nothing(-21.9, 100.0));
    EXPECT_FALSE(says_nothing(-250.0, -110.0));
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
