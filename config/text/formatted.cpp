#include "config/text/formatted.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <system_error>

namespace config {
namespace {

std::string formatted(double value, std::chars_format format, int precision) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
    assert(end.ec == std::errc{});
    return {text.data(), end.ptr};
}

}  // namespace

std::string with_digits(double value, int digits) {
    return formatted(value, std::chars_format::general, digits);
}

std::string with_decimals(double value, int decimals) {
    return formatted(value, std::chars_format::fixed, decimals);
}

}  // namespace config
