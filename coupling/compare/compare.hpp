#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

namespace coupling::compare {

struct CompareRequest {
    std::vector<std::filesystem::path> folders;  ///< of finished runs, the first is the reference
    std::filesystem::path out;                   ///< CSV file, empty for none
    std::filesystem::path page;                  ///< HTML file, empty for none
    bool overwrite = false;
    bool quiet = false;
};

/// Puts finished runs side by side on the screen and perhaps into a table and a page. Throws
/// config::InputError.
void compare_runs(const CompareRequest& request, std::ostream& screen);

}  // namespace coupling::compare
