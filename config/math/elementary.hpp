#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace config {

// Elementary functions whose bits depend on nothing but IEEE 754 addition, multiplication and division.
// Those of the C library pick other code on processors with fused multiply-add and may differ in the last bit
// from machine to machine; a rockfall run must not. Branch-free and short enough to inline. The series are
// summed in pairs instead of one term after the other: the chain of operations that wait for each other is
// half as long.

/// Base-2 logarithm, absolute error below 1e-13 for positive numbers, subnormal ones too.
///
/// Edges as those of std::log2: -infinity at 0, infinity at infinity, NaN below 0 and for NaN.
inline double log2_of(double x) {
    constexpr std::uint64_t smallest_normal_bits = 0x0010000000000000ULL;
    constexpr std::uint64_t infinity_bits = 0x7FF0000000000000ULL;
    auto bits = std::bit_cast<std::uint64_t>(x);
    double scaled_up_by = 0.0;
    // One comparison finds all that is not a positive normal number.
    if (bits - smallest_normal_bits >= infinity_bits - smallest_normal_bits) [[unlikely]] {
        if (!(x > 0.0)) {
            return x == 0.0 ? -std::numeric_limits<double>::infinity()
                            : std::numeric_limits<double>::quiet_NaN();
        }
        if (bits >= infinity_bits) {
            return x;
        }
        bits = std::bit_cast<std::uint64_t>(x * 0x1p54);
        scaled_up_by = 54.0;
    }
    // Take the exponent such that the mantissa lies in [sqrt(1/2), sqrt(2)): the series is short there.
    constexpr std::uint64_t sqrt_half_bits = 0x3FE6A09E667F3BCDULL;
    const auto exponent = static_cast<std::int64_t>(bits - sqrt_half_bits) >> 52;
    const auto mantissa = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << 52));
    const double s = (mantissa - 1.0) / (mantissa + 1.0);
    const double q = s * s;
    // 2 / ln 2 * atanh(s), atanh as its odd power series; |s| < 0.1716
    const double q2 = q * q;
    const double series = (1.0 + q * (1.0 / 3)) + q2 * (1.0 / 5 + q * (1.0 / 7)) +
                          q2 * q2 * ((1.0 / 9 + q * (1.0 / 11)) + q2 * (1.0 / 13 + q * (1.0 / 15)));
    return (static_cast<double>(exponent) - scaled_up_by) + 2.885390081777926814719849362 * s * series;
}

/// 2 to the power y for every y, relative error below 1e-11.
///
/// Below the smallest normal number the result loses digits and then is 0 (gradual underflow), beyond the
/// largest one it is infinity; NaN stays NaN. Edges as those of std::exp2.
inline double exp2_of(double y) {
    // Beyond these limits the result is 0 or infinity anyway. NaN passes: it compares false.
    const double bounded = std::min(std::max(y, -1080.0), 1030.0);
    constexpr double to_nearest = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to a whole number
    const double shifted = bounded + to_nearest;
    const double whole = shifted - to_nearest;
    const double f = (bounded - whole) * 0.693147180559945309417232121;  // |f| < 0.3466
    const double f2 = f * f;
    const double f4 = f2 * f2;
    const double series = (1.0 + f) + f2 * (1.0 / 2 + f * (1.0 / 6)) +
                          f4 * ((1.0 / 24 + f * (1.0 / 120)) + f2 * (1.0 / 720 + f * (1.0 / 5040)) +
                                f4 * (1.0 / 40320 + f * (1.0 / 362880)));
    // The whole number stands in the low bits of its shifted self. Two factors, each a normal number, reach
    // results that one factor of 2^whole could not; only the second product can round.
    const auto exponent = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(shifted) -
                                                    std::bit_cast<std::uint64_t>(to_nearest));
    const std::int64_t half = exponent >> 1;
    const auto power_of_two = [](std::int64_t n) {
        return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
    };
    return series * power_of_two(half) * power_of_two(exponent - half);
}

/// Natural logarithm; edges as log2_of.
inline double ln_of(double x) {
    return 0.693147180559945309417232121 * log2_of(x);
}
/// e to the power x; range, error and edges as exp2_of.
inline double exp_of(double x) {
    return exp2_of(1.442695040888963407359924681 * x);
}
/// x to the power p for x >= 0: relative error below 1e-11 + |p| * 1e-13. 1 where p is 0; NaN for x < 0.
inline double pow_of(double x, double p) {
    return p == 0.0 ? 1.0 : exp2_of(p * log2_of(x));
}

struct SinCos {
    double sin;
    double cos;
};

/// Sine and cosine of an angle of at most a right angle either way, absolute error below 1e-11.
inline SinCos sin_cos_of(double angle_rad) {
    const double q = angle_rad * angle_rad;
    const double q2 = q * q;
    const double q4 = q2 * q2;
    const double s = (1.0 + q * (-1.0 / 6)) + q2 * (1.0 / 120 + q * (-1.0 / 5040)) +
                     q4 * ((1.0 / 362880 + q * (-1.0 / 39916800)) +
                           q2 * (1.0 / 6227020800.0 + q * (-1.0 / 1307674368000.0)));
    const double c =
        (1.0 + q * (-1.0 / 2)) + q2 * (1.0 / 24 + q * (-1.0 / 720)) +
        q4 * ((1.0 / 40320 + q * (-1.0 / 3628800)) + q2 * (1.0 / 479001600 + q * (-1.0 / 87178291200.0)) +
              q4 * (1.0 / 20922789888000.0));
    return {angle_rad * s, c};
}

/// Arc tangent, absolute error below 1e-13 rad, for every number.
///
/// Two halvings of the angle leave at most pi/16 to the series.
inline double atan_of(double x) {
    const double size = x < 0.0 ? -x : x;
    const bool steep = size > 1.0;
    double t = steep ? 1.0 / size : size;
    for (int i = 0; i < 2; ++i) {
        t = t / (1.0 + std::sqrt(1.0 + t * t));
    }
    const double q = t * t;
    const double series =
        1.0 -
        q * (1.0 / 3 -
             q * (1.0 / 5 -
                  q * (1.0 / 7 -
                       q * (1.0 / 9 - q * (1.0 / 11 - q * (1.0 / 13 - q * (1.0 / 15 - q * (1.0 / 17))))))));
    const double angle_rad = 4.0 * t * series;
    constexpr double quarter_turn_rad = 1.570796326794896619231321691639751;
    const double positive_rad = steep ? quarter_turn_rad - angle_rad : angle_rad;
    return x < 0.0 ? -positive_rad : positive_rad;
}

}  // namespace config
