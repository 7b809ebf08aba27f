#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::report {

/// The program warns in English: on the screen, in summary.json and in parts. A page shows such a message in
/// its own language by messages.csv, whose rows are English patterns with placeholders and what stands for
/// them in German, French and Italian. A message is translated as a whole or not at all.
///
/// The name of a placeholder says what it stands for, digits behind it tell several of a kind apart:
///   {number}  a number; written as in the language
///   {place}   a name without ": ", such as "trees.csv:12"; as it is
///   {text}    anything, such as the name of a species; as it is
///   {words}   what is itself a message of the table, such as "5 trees"; translated

/// A message in the language in use (writing_language.hpp): itself in English, nothing where no row fits.
/// Messages above longest_message_bytes are left alone.
std::optional<std::string> translated(std::string_view message);

inline constexpr std::size_t longest_message_bytes = 2000;

/// The same as plain text: as it is where no row fits.
std::string message_text(std::string_view message);

/// The same as HTML: what has no translation is marked as English.
std::string message_html(std::string_view message);

/// The rows of the table: en, de, fr, it.
const std::vector<std::array<std::string, 4>>& all_messages();

}  // namespace coupling::report
