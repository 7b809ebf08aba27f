#include "config/text/encoding.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace config {
namespace {

/// Letters of Windows-1252 from 0x80 to 0x9F; the five that it leaves free are those of ISO-8859-1.
constexpr std::array<char16_t, 32> from_0x80{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                             0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                             0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                             0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

void append_utf8(char32_t letter, std::string& text) {
    if (letter < 0x80) {
        text += static_cast<char>(letter);
    } else if (letter < 0x800) {
        text += static_cast<char>(0xC0U | (letter >> 6U));
        text += static_cast<char>(0x80U | (letter & 0x3FU));
    } else {
        text += static_cast<char>(0xE0U | (letter >> 12U));
        text += static_cast<char>(0x80U | ((letter >> 6U) & 0x3FU));
        text += static_cast<char>(0x80U | (letter & 0x3FU));
    }
}

std::string from_windows_1252(std::string_view text) {
    std::string result;
    result.reserve(text.size() + text.size() / 8);
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        append_utf8(byte >= 0x80 && byte < 0xA0 ? from_0x80[byte - 0x80U] : byte, result);
    }
    return result;
}

/// Bytes of the letter that begins here; 0 where none does.
std::size_t length_of_letter(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = at(0);
    if (first < 0x80) {
        return 1;
    }
    const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || text.size() < length) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((at(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    const bool is_wrong = (first == 0xE0 && at(1) < 0xA0) || (first == 0xED && at(1) >= 0xA0) ||
                          (first == 0xF0 && at(1) < 0x90) || (first == 0xF4 && at(1) >= 0x90);
    return is_wrong ? 0 : length;
}

}  // namespace

std::optional<Encoding> encoding_named(std::string_view name) {
    std::string letters;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) {
            letters += static_cast<char>(std::tolower(byte));
        }
    }
    constexpr std::array<std::string_view, 2> utf{"utf8", "65001"};
    constexpr std::array<std::string_view, 8> western{"1252",     "cp1252", "windows1252", "ansi1252",
                                                      "iso88591", "88591",  "latin1",      "iso885915"};
    if (std::find(utf.begin(), utf.end(), letters) != utf.end()) {
        return Encoding::utf_8;
    }
    if (std::find(western.begin(), western.end(), letters) != western.end()) {
        return Encoding::windows_1252;
    }
    return std::nullopt;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = length_of_letter(text);
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

std::string to_utf8(std::string_view text, Encoding encoding) {
    const bool as_it_is = encoding != Encoding::windows_1252 && is_utf8(text);
    return as_it_is ? std::string{text} : from_windows_1252(text);
}

}  // namespace config
