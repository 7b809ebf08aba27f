#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace coupling::geopackage {

/// The number that a whole field is, or nothing.
///
/// Figures as tables write them, "-12.345" with at most fifteen digits, take a short way: a whole number
/// below 2^53 divided by a power of ten that a double holds exactly is rounded once, so it is the double
/// nearest to the text (Clinger 1990), as std::from_chars finds it for every other field.
inline std::optional<double> plain_number(std::string_view field) {
    constexpr std::array<double, 16> powers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool negative = !field.empty() && field.front() == '-';
    std::uint64_t digits = 0;
    std::size_t count = 0;
    std::size_t decimals = 0;
    bool after_point = false;
    bool plain = true;
    for (std::size_t i = negative ? 1 : 0; plain && i < field.size(); ++i) {
        const char c = field[i];
        if (c >= '0' && c <= '9') {
            digits = 10 * digits + static_cast<std::uint64_t>(c - '0');
            decimals += after_point ? 1 : 0;
            plain = ++count < powers.size();
        } else {
            plain = c == '.' && !after_point && count > 0;
            after_point = true;
        }
    }
    if (plain && count > 0) {
        const double size = static_cast<double>(digits) / powers[decimals];
        return negative ? -size : size;
    }
    double value = 0.0;
    const char* const end = field.data() + field.size();
    const auto [last, error] = std::from_chars(field.data(), end, value);
    return error == std::errc{} && last == end ? std::optional{value} : std::nullopt;
}

}  // namespace coupling::geopackage
