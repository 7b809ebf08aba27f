#include "config/options/values.hpp"

#include <gtest/gtest.h>

namespace config::values_test {
namespace {

TEST(NumberIn, HoldsTheRange) {
    const NumberRange range{0.0, 2.0};
    EXPECT_EQ(number_in("0.35", range), 0.35);
    for (const char* text : {"0,35", "nan", "inf", "-1", "2.1", "", "0.35 m"}) {
        EXPECT_FALSE(number_in(text, range)) << text;
    }
}

TEST(CountIn, TakesAllOf64Bits) {
    EXPECT_EQ(count_in("18446744073709551615", {}), 18446744073709551615ULL);
    EXPECT_EQ(count_in("1e6", {}), 1'000'000U);
    EXPECT_EQ(count_in("+3", {}), 3U);
    for (const char* text : {"-1", "1.5", "nan", "1,5", "18446744073709551616", "", "0x10"}) {
        EXPECT_FALSE(count_in(text, {})) << text;
    }
    EXPECT_FALSE(count_in("11", {0.0, 10.0}));
}

TEST(FlagIn, TakesTheUsualWords) {
    for (const char* text : {"yes", "TRUE", "on", "1"}) {
        EXPECT_EQ(flag_in(text), true) << text;
    }
    for (const char* text : {"no", "False", "off", "0"}) {
        EXPECT_EQ(flag_in(text), false) << text;
    }
    EXPECT_FALSE(flag_in("y"));
}

TEST(NumbersIn, TakesCommasAndBlanks) {
    const std::vector<double> expected{0.5, 1.0, 1.5};
    EXPECT_EQ(numbers_in("0.5, 1.0 1.5", {}), expected);
    EXPECT_EQ(numbers_in("0.5,1.0,1.5", {}), expected);
    EXPECT_EQ(numbers_in(" 0.5\t1 1.5 ", {}), expected);
    EXPECT_EQ(numbers_in("0.5 , 1, 1.5", {}), expected);
    EXPECT_EQ(numbers_in("10, 20", {}), (std::vector<double>{10.0, 20.0}));
    EXPECT_EQ(numbers_in("", {}), std::vector<double>{});
}

TEST(NumbersIn, RefusesWhatMayBeDecimalCommas) {
    for (const char* text : {"1,5", "0,5 1,0", "0,5, 1,0", "0.5; 1.0", "1.0,,2.0", "1.0, ", ", 1.0", "nan"}) {
        EXPECT_FALSE(numbers_in(text, {})) << text;
    }
}

TEST(WholeNumbersIn, NeedNoBlankAfterAComma) {
    const std::vector<double> expected{0.0, 5.0, 100.0};
    for (const char* text : {"0,5,100", "0, 5, 100", "0 5 100", " 0 ,5\t100 ", "0,5 1e2"}) {
        EXPECT_EQ(whole_numbers_in(text, {}), expected) << text;
    }
    EXPECT_EQ(whole_numbers_in("", {}), std::vector<double>{});
    for (const char* text : {"0.5", "0,5.5", "1,,2", "1,", ",1", "1;2", "nan", "x"}) {
        EXPECT_FALSE(whole_numbers_in(text, {})) << text;
    }
    EXPECT_FALSE(whole_numbers_in("1,1001", {0.0, 1000.0}));
}

TEST(NumbersIn, HoldsTheRangeForEach) {
    EXPECT_FALSE(numbers_in("0.5, 3", {0.0, 2.0}));
}

}  // namespace
}  // namespace config::values_test
