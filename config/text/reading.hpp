#pragma once

#include <istream>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"

namespace config {

/// All of a text file: UTF-8 without its byte-order mark. Throws InputError (`code`) for UTF-16, as some
/// programs save "Unicode text", and for bytes of zero, which no text holds.
std::string read_text(std::istream& in, const std::string& file, ExitCode code = ExitCode::data);
/// The same of bytes in memory, which the result refers to.
std::string_view checked_text(std::string_view bytes, const std::string& file,
                              ExitCode code = ExitCode::data);

/// The text without the byte-order mark that Windows programs put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// Whether the character separates words: a blank, a tab, a carriage return or a line feed.
inline bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/// The text without blanks, tabs, carriage returns and line feeds at both ends.
std::string_view trimmed(std::string_view text);

/// The text with the letters A to Z in lower case; others, such as those of UTF-8, stay.
std::string in_lower_case(std::string_view text);

}  // namespace config
