#include "config/text/formatted.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "config/text/numbers.hpp"

namespace config::formatted_test {
namespace {

TEST(Formatted, HasSoManyDigitsOrDecimals) {
    EXPECT_EQ(with_digits(123.4567891, 6), "123.457");
    EXPECT_EQ(with_digits(1e-7, 6), "1e-07");
    EXPECT_EQ(with_digits(0.5, 6), "0.5");
    EXPECT_EQ(with_decimals(46.8, 8), "46.80000000");
    EXPECT_EQ(with_decimals(-11.000000004, 8), "-11.00000000");
}

/// What is written is the number to half of the last place.
RC_GTEST_PROP(Formatted, ReadsBackToTheLastPlace, ()) {
    const double value = *rc::gen::inRange(-1'000'000, 1'000'000) / 7919.0;
    const auto back = parse_number(with_decimals(value, 5));
    RC_ASSERT(back && std::abs(*back - value) <= 0.5000001e-5);
    const auto digits = parse_number(with_digits(value, 6));
    RC_ASSERT(digits && std::abs(*digits - value) <= 0.5000001e-5 * std::abs(value));
}

}  // namespace
}  // namespace config::formatted_test
