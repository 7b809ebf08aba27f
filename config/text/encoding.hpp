#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace config {

/// How the bytes of a text stand for letters.
enum class Encoding : std::uint8_t {
    unknown,  ///< UTF-8 where it is that, else Windows-1252
    utf_8,
    windows_1252,  ///< as Windows writes in western Europe; a superset of ISO-8859-1's letters
};

/// The encoding that a name such as "UTF-8", "ISO88591", "cp1252" or "1252" stands for; nothing for others.
std::optional<Encoding> encoding_named(std::string_view name);

/// Whether all bytes are UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF.
bool is_utf8(std::string_view text);

/// A text as UTF-8. What is said to be UTF-8 and is not is taken as Windows-1252.
std::string to_utf8(std::string_view text, Encoding encoding);

}  // namespace config
