#pragma once

#include <string>
#include <string_view>

namespace config {

/// A text as a shell takes it for one word: as it is, or in single quotes where it holds more than letters,
/// digits and the signs of paths.
std::string shell_word(std::string_view text);

}  // namespace config
