#pragma once

#include <string_view>

namespace coupling {

/// Whether a regime or a climate may have this name: folders and files of the results have it too. At most
/// 100 letters without accents, digits, `_` and `-`; neither `bare` nor `year_...`, which are folders
/// already.
bool is_result_name(std::string_view name);

/// The same in words, for messages.
inline constexpr const char* result_name_in_words =
    "at most 100 letters (no accents), digits, _ or -, other than 'bare' and 'year_...'; rename it: folders "
    "of the results take this name";

}  // namespace coupling
