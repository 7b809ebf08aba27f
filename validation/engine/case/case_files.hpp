#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::validation {

/// The files of one case, as they were built into the program or lie in a folder.
struct CaseFiles {
    std::string name;                          ///< of its folder, such as "vaujany_open"
    std::string folder;                        ///< in messages
    std::map<std::string, std::string> texts;  ///< by file name
    std::filesystem::path path{};              ///< of the folder; empty: built into the program

    [[nodiscard]] bool is_own() const { return !path.empty(); }
    [[nodiscard]] bool has(const std::string& file) const { return texts.contains(file); }
    /// Name of a file in messages.
    [[nodiscard]] std::string shown(const std::string& file) const { return folder + '/' + file; }
    /// Throws InputError (file) where it is missing.
    [[nodiscard]] config::Table table(const std::string& file) const;
};

/// The cases of the folder validation/ as they stood when the program was built, in alphabetical order.
std::vector<CaseFiles> shipped_cases();

/// The cases of a folder: each folder in it that holds a case.ini, or the folder itself if it holds one.
/// Throws InputError (file) where none does or one cannot be read.
std::vector<CaseFiles> cases_in(const std::filesystem::path& folder);

}  // namespace coupling::validation
