#include "coupling/inputs/places/exposure_checks.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace coupling::exposure_checks_test {
namespace {

TEST(TargetExposure, FindsAColumnThatIsCalledLikeAnother) {
    for (const char* column : {"value", "Value", "house_value", "HouseValue", "Building value", "value_chf",
                               "house_vaule", "valu", "values", "house-valve"}) {
        EXPECT_TRUE(has_word_like(column, "value")) << column;
    }
    for (const char* column : {"house", "house_number", "evaluation", "", "val", "_"}) {
        EXPECT_FALSE(has_word_like(column, "value")) << column;
    }
    EXPECT_TRUE(has_word_like("person", "persons"));
    EXPECT_FALSE(has_word_like("personnel", "persons"));
}

/// Each word with any one letter left out, doubled, replaced, or two neighbours exchanged is still found;
/// with two letters replaced it is not.
TEST(TargetExposure, AllowsOneSlipOfTheKeyboard) {
    for (const std::string word : {"value", "persons", "hours", "vehicles", "speed"}) {
        for (std::size_t i = 0; i < word.size(); ++i) {
            std::string slip = word;
            EXPECT_TRUE(has_word_like(slip.erase(i, 1), word)) << slip;
            slip = word;
            EXPECT_TRUE(has_word_like(slip.insert(i, 1, word[i]), word)) << slip;
            slip = word;
            slip[i] = 'z';
            EXPECT_TRUE(has_word_like(slip, word)) << slip;
            if (i + 2 < word.size()) {
                slip[i + 2] = 'z';
                EXPECT_FALSE(has_word_like(slip, word)) << slip;
            }
            if (i + 1 < word.size()) {
                slip = word;
                std::swap(slip[i], slip[i + 1]);
                EXPECT_TRUE(has_word_like(slip, word)) << slip;
            }
        }
    }
}

}  // namespace
}  // namespace coupling::exposure_checks_test
