#pragma once

#include <cstddef>
#include <string_view>

namespace config {

/// How many lines stand above the header of a table, as services put titles, places and explanations there.
///
/// The header is the first line with as many fields as each line below it, where none of its fields is a
/// number and the lines above have fewer fields, or end with an empty line. It may stand behind a `#`. A
/// table whose first line is its header has none, and so has one with uneven rows: what is wrong with it is
/// for its reader to say. `text`: lines that end in '\n'.
std::size_t lines_above_header(std::string_view text);

}  // namespace config
