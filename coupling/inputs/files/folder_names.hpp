#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coupling/inputs/files/input_names.hpp"

namespace coupling {

/// What a text calls folders outside of the project by: "outside/", as in results (InputNames), and what
/// stands for it, such as "../maps/".
using FolderNames = std::vector<std::pair<std::string, std::string>>;

/// All folders elsewhere, by their names in settings; by their paths where only tables name them. `settings`
/// holds the files of settings: each by its name for results, and as it is written.
FolderNames folder_names(const InputNames& names,
                         const std::vector<std::pair<std::string, std::string>>& settings);

/// The same for pages: of a folder that is named by its whole path, or by tables alone, nothing is shown, as
/// results have the same bytes on any machine.
FolderNames folder_names_on_pages(const InputNames& names,
                                  const std::vector<std::pair<std::string, std::string>>& settings);

/// A text with the names of files elsewhere replaced: "outside/dem.asc" becomes "../maps/dem.asc".
std::string with_folder_names(std::string text, const FolderNames& folders);

/// Where an archive keeps those of the pages of its run, beside its scenario.
inline constexpr const char* folder_names_file = "bannwald_folders.txt";

/// A line each: "outside/ = ../maps/".
std::string text_of(const FolderNames& folders);
FolderNames folder_names_of(std::string_view text);

}  // namespace coupling
