#pragma once

#include <array>
#include <charconv>
#include <string>

namespace coupling {

/// A number as other programs read it: fixed decimals, a plain minus sign, a decimal point in any locale.
inline std::string plain_number(double value, int decimals) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

}  // namespace coupling
