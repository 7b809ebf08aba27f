#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"

namespace config {

/// One assignment of a settings file or of a command line.
struct IniEntry {
    std::string section;  ///< "" before the first section
    std::string name;
    std::string value;  ///< without quotes and comment
    Place key_place;
    Place value_place;
    std::string comment{};  ///< behind the value, without its sign

    [[nodiscard]] std::string key() const { return section.empty() ? name : section + '.' + name; }
};

/// Longest file of settings [bytes], and how many problems it may have before reading ends [choice]: a file
/// of another kind is recognised by them.
inline constexpr std::size_t longest_ini_bytes = 1 << 20;
inline constexpr std::size_t most_ini_problems = 100;

/// The assignments of an INI file, in their order. Lines that are none become problems (settings). Throws
/// InputError (settings) for a file that is longer than longest_ini_bytes or no text.
///
/// Takes UTF-8 with or without byte-order mark, LF or CRLF. `#` and `;` begin a comment at the start of a
/// line or after a blank. A value in "double quotes" keeps its blanks and comment signs; a quote in it is
/// doubled.
std::vector<IniEntry> read_ini(std::istream& in, const std::string& file, Problems& problems);

/// The assignment of a command line, "section.key=value"; its place is the text itself.
std::vector<IniEntry> read_override(const std::string& text, Problems& problems);

/// A value as `read_ini` takes it back: in quotes where it needs them. Requires one line.
std::string ini_value(std::string_view value);

}  // namespace config
