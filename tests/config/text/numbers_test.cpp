#include "config/text/numbers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace config::numbers_test {
namespace {

TEST(ParseNumber, TakesDecimalAndScientificNotation) {
    EXPECT_EQ(parse_number("1.5"), 1.5);
    EXPECT_EQ(parse_number("+1.5"), 1.5);
    EXPECT_EQ(parse_number("-.5e3"), -500.0);
    EXPECT_EQ(parse_number("2."), 2.0);
}

TEST(ParseNumber, RefusesWhatIsNotWhollyAFiniteNumber) {
    for (const char* text : {"", "+", "-", "nan", "NaN", "inf", "-inf", "1,5", "3abc", "1.5 ", " 1", "+-1",
                             "++1", "0x10", "1e999"}) {
        EXPECT_FALSE(parse_number(text)) << text;
    }
}

TEST(ParseWhole, TakesAnyNotationWithoutAFraction) {
    EXPECT_EQ(parse_whole("-12"), -12);
    EXPECT_EQ(parse_whole("+12"), 12);
    EXPECT_EQ(parse_whole("12.0"), 12);
    EXPECT_EQ(parse_whole("1e6"), 1'000'000);
    EXPECT_EQ(parse_whole("9223372036854775807"), 9223372036854775807LL);
    for (const char* text : {"", "1.5", "1e-3", "nan", "1,5", "9223372036854775808"}) {
        EXPECT_FALSE(parse_whole(text)) << text;
    }
}

TEST(ParseWhole, RefusesAPointThatMaySeparateThousands) {
    for (const char* text : {"2.000", "-2.000", "12.345", "1.234.567"}) {
        EXPECT_FALSE(parse_whole(text)) << text;
    }
    EXPECT_EQ(parse_whole("2000.000"), 2000);  // as programs write whole numbers with decimals
    EXPECT_EQ(parse_whole("0.000"), 0);
}

TEST(WithoutSeparators, ReadsTheHabitsOfEurope) {
    for (const char* text :
         {"2.000", "2,000", "2'000", "2 000", "2_000", "2\u2019000", "2\u00A0000", "2\u202F000", "+2.000"}) {
        EXPECT_EQ(without_separators(text), "2000") << text;
    }
    EXPECT_EQ(without_separators("-12.345.678"), "-12345678");
    EXPECT_EQ(without_separators("1.234,5"), "1234.5");
    EXPECT_EQ(without_separators("1'234.5"), "1234.5");
    EXPECT_EQ(without_separators("1,234.5"), "1234.5");
}

TEST(WithoutSeparators, LeavesOtherNumbersAlone) {
    for (const char* text : {"", "2000", "2.0", "2.00", "2.0000", "0.125", "0,5", "1234.567", "1.23.456",
                             "1,5", "2.000x", "a", ".000", "1e3", "2.000.", "1.000,", "1 2"}) {
        EXPECT_FALSE(without_separators(text)) << text;
    }
}

RC_GTEST_PROP(ToText, ReadsBackAsTheSameNumber, (double value)) {
    RC_PRE(std::isfinite(value));
    RC_ASSERT(parse_number(to_text(value)) == value);
}

TEST(ToText, IsAsShortAsItCanBe) {
    EXPECT_EQ(to_text(0.3), "0.3");
    EXPECT_EQ(to_text(0.3F), "0.3");
    EXPECT_EQ(to_text(10.0), "10");
}

TEST(NumberRange, IsDescribedInWords) {
    EXPECT_EQ(describe("a number", {0.0, 2.0}), "a number in [0, 2]");
    EXPECT_EQ(describe("a number", {0.0, 2.0, true}), "a number in (0, 2]");
    EXPECT_EQ(describe("a number", {.low = 0.0}), "a number >= 0");
    EXPECT_EQ(describe("a number", {.low = 0.0, .low_excluded = true}), "a number > 0");
    EXPECT_EQ(describe("a number", {.high = 1.0}), "a number <= 1");
    EXPECT_EQ(describe("a number", {}), "a number");
}

TEST(NumberRange, KnowsWhetherItsLowerEndBelongsToIt) {
    EXPECT_TRUE((NumberRange{0.0, 2.0}.contains(0.0)));
    EXPECT_FALSE((NumberRange{0.0, 2.0, true}.contains(0.0)));
    EXPECT_TRUE((NumberRange{0.0, 2.0, true}.contains(2.0)));
}

TEST(ToText, HasAnExponentOnlyWhereNoCoordinateLies) {
    EXPECT_EQ(to_text(5e5), "500000");
    EXPECT_EQ(to_text(-3e5), "-300000");
    EXPECT_EQ(to_text(1e9), "1000000000");
    EXPECT_EQ(to_text(0.0001), "0.0001");
    EXPECT_EQ(to_text(0.0), "0");
    EXPECT_EQ(to_text(5e5F), "500000");
    EXPECT_EQ(to_text(1e-7), "1e-07");
    EXPECT_EQ(to_text(1e300), "1e+300");
}

RC_GTEST_PROP(ToText, ReadsBackTheSameBits, (double value)) {
    RC_PRE(std::isfinite(value));
    RC_ASSERT(parse_number(to_text(value)) == value);
    const double round = std::trunc(value * 100.0) * 1000.0;
    RC_ASSERT(!std::isfinite(round) || parse_number(to_text(round)) == round);
}

}  // namespace
}  // namespace config::numbers_test
