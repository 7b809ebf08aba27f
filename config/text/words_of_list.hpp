#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace config {

/// The words between the commas of a setting, without blanks: "plate, cube" -> {"plate", "cube"}. An empty
/// text is one empty word.
std::vector<std::string> words_of_list(std::string_view text);

/// The words between blanks: "1 2" -> {"1", "2"}. None of an empty text.
std::vector<std::string> words_between_blanks(std::string_view text);

}  // namespace config
