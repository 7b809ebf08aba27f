#pragma once

#include <cstdint>
#include <ostream>
#include <string>

namespace coupling {

/// A line of a listing: a name, padded, and what there is to say.
void say(std::ostream& out, const std::string& name, const std::string& text);

/// "12.3 kB", "1.2 MB".
std::string size_in_words(std::uint64_t bytes);

/// "a second", "30 s", "12 min", "3 h".
std::string duration(double seconds);

}  // namespace coupling
