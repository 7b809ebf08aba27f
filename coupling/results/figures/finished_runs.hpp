#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace coupling {

/// Folders of finished runs in a folder: the hazard map, then others by the numbers in their names. Empty
/// where the folder does not exist.
std::vector<std::filesystem::path> finished_runs_in(const std::filesystem::path& folder);

/// What a user who named `folder` may have meant: "name the folder of a finished run: a, b or c" with those
/// in it, without names where it holds none.
std::string name_a_finished_run(const std::filesystem::path& folder);

}  // namespace coupling
