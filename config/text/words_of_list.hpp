#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace config {

/// The words between the commas of a setting, without blanks: "plate, cube" -> {"plate", "cube"}. An empty
/// text is one empty word.
std::vector<std::string> words_of_list(std::string_view text);

}  // namespace config
