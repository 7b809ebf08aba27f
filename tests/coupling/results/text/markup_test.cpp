#include "coupling/results/text/markup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "coupling/results/text/writing_language.hpp"

namespace coupling::report::markup_test {
namespace {

TEST(Escaped, LeavesNoTagBehind) {
    EXPECT_EQ(escaped("<b> \"a\" & b"), "&lt;b&gt; &quot;a&quot; &amp; b");
}

TEST(ThreeDigits, NeedsNoExponent) {
    EXPECT_EQ(three_digits(0.012345), "0.0123");
    EXPECT_EQ(three_digits(1.0), "1.00");
    EXPECT_EQ(three_digits(99.96), "100");
    EXPECT_EQ(three_digits(12345.0), "12\u202f300");
    EXPECT_EQ(three_digits(0.0), "0");
    EXPECT_EQ(three_digits(-26.04), "\u221226.0");
    EXPECT_EQ(three_digits(std::numeric_limits<double>::quiet_NaN()), "–");
}

TEST(TickText, HasNoNeedlessZeros) {
    EXPECT_EQ(tick_text(0.1), "0.1");
    EXPECT_EQ(tick_text(20.0), "20");
    EXPECT_EQ(tick_text(1000.0), "1\u202f000");
    EXPECT_EQ(tick_text(0.0001), "0.0001");
}

TEST(Grouped, SeparatesThousands) {
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1234567), "1\u202f234\u202f567");
}

TEST(Percent, KeepsThreeDigitsOfSmallShares) {
    EXPECT_EQ(percent(0.123), "12.3\u00a0%");
    EXPECT_EQ(percent(0.00205), "0.205\u00a0%");
    EXPECT_EQ(percent(1.0), "100.0\u00a0%");
}

TEST(Percent, SaysLessThanAHundredthInWords) {
    EXPECT_EQ(percent(0.0), "0\u00a0%");
    EXPECT_EQ(percent(0.000000678), "less than 0.01\u00a0%");
    EXPECT_EQ(percent(0.0000999), "less than 0.01\u00a0%");
    EXPECT_EQ(percent(0.0001), "0.0100\u00a0%");
    EXPECT_EQ(percent(0.000153), "0.0153\u00a0%");
    EXPECT_EQ(percent(-0.000076), "\u22120.01\u00a0%");
    EXPECT_EQ(percent(-0.00000076), "0.00\u00a0%");
    EXPECT_EQ(percent(std::nan("")), "–");
    const WritingLanguage german{config::Language::de};
    EXPECT_EQ(percent(0.000000678), "weniger als 0,01\u00a0%");
}

/// Over ten powers of ten: an area above 0 never reads as 0, and it is never further off than its last digit.
TEST(Hectares, AreNeverRoundedAway) {
    EXPECT_EQ(hectares(0.0), "0");
    EXPECT_EQ(hectares(0.0025), "less than 0.01");
    EXPECT_EQ(hectares(0.0099), "less than 0.01");
    EXPECT_EQ(hectares(0.01), "0.01");
    EXPECT_EQ(hectares(9.994), "9.99");
    EXPECT_EQ(hectares(9.996), "10.0");
    EXPECT_EQ(hectares(1234.56), "1\u202f234.6");
    EXPECT_EQ(hectares(std::numeric_limits<double>::quiet_NaN()), "–");
    for (double area_ha = 1e-6; area_ha < 100.0; area_ha *= 1.37) {
        const std::string text = hectares(area_ha);
        const bool is_small = text.starts_with("less than ");
        EXPECT_EQ(is_small, area_ha < 0.01) << text;
        if (!is_small) {
            EXPECT_NEAR(std::stod(text), area_ha, area_ha < 9.995 ? 0.005001 : 0.05001);
        }
    }
    const WritingLanguage german{config::Language::de};
    EXPECT_EQ(hectares(0.004), "weniger als 0,01");
}

TEST(Place, IsShort) {
    EXPECT_EQ(place(3.0), "3");
    EXPECT_EQ(place(-0.04), "0");
    EXPECT_EQ(place(12.34), "12.3");
}

TEST(NiceStep, IsOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_DOUBLE_EQ(nice_step(1.0), 1.0);
    EXPECT_DOUBLE_EQ(nice_step(1.1), 2.0);
    EXPECT_DOUBLE_EQ(nice_step(0.03), 0.05);
    EXPECT_DOUBLE_EQ(nice_step(70.0), 100.0);
}

}  // namespace
}  // namespace coupling::report::markup_test
