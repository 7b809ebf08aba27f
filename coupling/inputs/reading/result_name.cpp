#include "coupling/inputs/reading/result_name.hpp"

#include <algorithm>

namespace coupling {

bool is_result_name(std::string_view name) {
    constexpr std::size_t longest = 100;
    const auto is_fine = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    const bool is_taken = name == "bare" || name.starts_with("year_");
    return !name.empty() && name.size() <= longest && !is_taken &&
           std::all_of(name.begin(), name.end(), is_fine);
}

}  // namespace coupling
