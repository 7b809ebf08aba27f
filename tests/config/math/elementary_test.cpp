#include "config/math/elementary.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace config::elementary_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double smallest_normal = std::numeric_limits<double>::min();
constexpr double largest = std::numeric_limits<double>::max();

/// What is left of `relative` for numbers so small that their last digit is larger.
double tolerance(double expected, double relative) {
    return std::max(relative * std::abs(expected), smallest);
}

/// Any double but a NaN, each bit pattern as likely as another.
double any_number(std::uint64_t bits) {
    double x = 0.0;
    std::memcpy(&x, &bits, sizeof x);
    return std::isnan(x) ? 1.0 : x;
}

TEST(ExpOf, MatchesTheLibraryFromUnderflowToOverflow) {
    for (int i = -760'000; i <= 720'000; ++i) {
        const double x = 1e-3 * i;
        const double expected = std::exp(x);
        if (std::isinf(expected)) {
            ASSERT_EQ(exp_of(x), infinity) << x;
        } else {
            ASSERT_NEAR(exp_of(x), expected, tolerance(expected, 1e-11)) << x;
        }
    }
}

TEST(ExpOf, NeverFallsWhereItsArgumentRisesThroughUnderflow) {
    double before = 0.0;
    for (int i = -8'000; i <= -6'900; ++i) {
        const double value = exp_of(0.1 * i);
        ASSERT_GE(value, before) << 0.1 * i;
        before = value;
    }
    EXPECT_GT(before, smallest_normal);
}

TEST(ExpOf, HasTheEdgesOfTheLibrary) {
    EXPECT_EQ(exp_of(-infinity), 0.0);
    EXPECT_EQ(exp_of(-largest), 0.0);
    EXPECT_EQ(exp_of(-746.0), 0.0);
    EXPECT_GT(exp_of(-744.0), 0.0);
    EXPECT_EQ(exp_of(-smallest), 1.0);
    EXPECT_EQ(exp_of(0.0), 1.0);
    EXPECT_TRUE(std::isfinite(exp_of(709.78)));
    EXPECT_EQ(exp_of(709.79), infinity);
    EXPECT_EQ(exp_of(largest), infinity);
    EXPECT_EQ(exp_of(infinity), infinity);
    EXPECT_TRUE(std::isnan(exp_of(nan)));
}

RC_GTEST_PROP(ExpOf, MatchesTheLibraryForAnyNumber, (std::uint64_t bits)) {
    const double x = any_number(bits);
    const double expected = std::exp(x);
    RC_ASSERT(exp_of(x) == expected || std::abs(exp_of(x) - expected) <= tolerance(expected, 1e-11));
}

TEST(Exp2Of, IsExactAtEveryPowerOfTwo) {
    for (int n = -1100; n <= 1050; ++n) {
        EXPECT_EQ(exp2_of(n), std::ldexp(1.0, n)) << n;
    }
}

TEST(Exp2Of, MatchesTheLibraryAroundTheEndsOfTheRange) {
    for (const double end : {-1075.0, -1074.0, -1023.5, -1023.0, -1022.5, -1022.0, 1023.0, 1023.5, 1024.0}) {
        for (int i = -1000; i <= 1000; ++i) {
            const double y = end + 1e-3 * i;
            const double expected = std::exp2(y);
            if (std::isinf(expected)) {
                ASSERT_EQ(exp2_of(y), infinity) << y;
            } else {
                ASSERT_NEAR(exp2_of(y), expected, tolerance(expected, 1e-11)) << y;
            }
        }
    }
}

TEST(Log2Of, IsExactAtEveryPowerOfTwo) {
    for (int n = -1074; n <= 1023; ++n) {
        EXPECT_EQ(log2_of(std::ldexp(1.0, n)), n);
    }
}

TEST(LnOf, HasTheEdgesOfTheLibrary) {
    EXPECT_EQ(ln_of(0.0), -infinity);
    EXPECT_EQ(ln_of(-0.0), -infinity);
    EXPECT_EQ(ln_of(1.0), 0.0);
    EXPECT_EQ(ln_of(infinity), infinity);
    EXPECT_TRUE(std::isnan(ln_of(-smallest)));
    EXPECT_TRUE(std::isnan(ln_of(-infinity)));
    EXPECT_TRUE(std::isnan(ln_of(nan)));
}

RC_GTEST_PROP(LnOf, MatchesTheLibraryForAnyPositiveNumber, (std::uint64_t bits)) {
    const double x = std::abs(any_number(bits));
    RC_PRE(x > 0.0 && x < infinity);
    RC_ASSERT(std::abs(log2_of(x) - std::log2(x)) <= 1e-13 + 1e-15 * std::abs(std::log2(x)));
    RC_ASSERT(std::abs(ln_of(x) - std::log(x)) <= 1e-13 + 1e-15 * std::abs(std::log(x)));
}

TEST(LnOf, MatchesTheLibraryAmongSubnormalNumbers) {
    for (double x = smallest; x < 4.0 * smallest_normal; x *= 1.37) {
        EXPECT_NEAR(ln_of(x), std::log(x), 1e-12) << x;
        x += smallest;  // the first steps would round to nothing
    }
}

RC_GTEST_PROP(PowOf, MatchesTheLibraryForAnyPositiveBase, (std::uint64_t bits, std::int32_t draw)) {
    const double x = std::abs(any_number(bits));
    RC_PRE(x < infinity);

    const double p = 1e-8 * draw;  // within 21.5 of 0
    const double expected = std::pow(x, p);
    const double relative = 1e-11 + std::abs(p) * 1e-12;
    RC_ASSERT(pow_of(x, p) == expected || std::abs(pow_of(x, p) - expected) <= tolerance(expected, relative));
}

TEST(PowOf, HasTheEdgesOfTheLibrary) {
    for (const double x : {0.0, smallest, 0.5, 1.0, 2.0, largest, infinity}) {
        for (const double p : {-300.0, -2.0, -0.5, 0.0, 0.5, 2.0, 300.0}) {
            EXPECT_EQ(pow_of(x, p) == 0.0, std::pow(x, p) == 0.0) << x << "^" << p;
            EXPECT_EQ(std::isinf(pow_of(x, p)), std::isinf(std::pow(x, p))) << x << "^" << p;
        }
        EXPECT_EQ(pow_of(x, 0.0), 1.0);
    }
    EXPECT_TRUE(std::isnan(pow_of(-1.0, 0.5)));
    EXPECT_TRUE(std::isnan(pow_of(nan, 0.5)));
}

RC_GTEST_PROP(SinCosOf, MatchesTheLibraryUpToARightAngle, (std::int32_t draw)) {
    const double angle_rad = 1.5707963267948966 * draw / 2147483648.0;
    const SinCos found = sin_cos_of(angle_rad);
    RC_ASSERT(std::abs(found.sin - std::sin(angle_rad)) < 1e-11);
    RC_ASSERT(std::abs(found.cos - std::cos(angle_rad)) < 1e-11);
}

TEST(AtanOf, MatchesTheLibraryEverywhere) {
    for (double x = -50.0; x <= 50.0; x += 0.0137) {
        EXPECT_NEAR(atan_of(x), std::atan(x), 2e-13) << x;
    }
    EXPECT_EQ(atan_of(0.0), 0.0);
    EXPECT_NEAR(atan_of(1e300), std::atan(1e300), 1e-13);
}

}  // namespace
}  // namespace config::elementary_test
