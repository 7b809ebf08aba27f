#pragma once

#include <string_view>

namespace config {

/// Whether a field says in words that there is no value, as spreadsheets, statistics programs and people do:
/// NA, #N/A, NULL, a lone dash.
bool says_no_value(std::string_view text);

}  // namespace config
