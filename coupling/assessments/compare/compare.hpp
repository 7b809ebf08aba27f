#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <vector>

#include "config/text/language.hpp"

namespace coupling::compare {

struct CompareRequest {
    std::vector<std::filesystem::path> folders;  ///< of finished runs, the first is the reference
    std::filesystem::path out;                   ///< folder of table and page, empty for none
    std::filesystem::path page;                  ///< the page alone, empty for none
    std::optional<config::Language> language{};  ///< of the page; none: that of the first run
    bool overwrite = false;
    bool quiet = false;
};

/// Puts finished runs side by side on the screen and perhaps into a folder with table and page. Throws
/// config::InputError.
void compare_runs(const CompareRequest& request, std::ostream& screen);

}  // namespace coupling::compare
