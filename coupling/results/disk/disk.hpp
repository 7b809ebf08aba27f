#pragma once

#include <filesystem>

#include "coupling/inputs/files/path_checks.hpp"

namespace coupling {

// What must have reached the disk, and entries of folders. Each throws config::InputError (file) naming the
// entry and the reason.

/// Returns once the bytes of a file are on the disk.
void sync_file(const std::filesystem::path& file);

/// Returns once the names in a folder are on the disk: of files that were made, renamed or deleted in it.
/// Does nothing for a folder that this user may not read.
void sync_folder(const std::filesystem::path& folder);

/// Both, for everything below a folder and for the folder itself.
void sync_all_below(const std::filesystem::path& folder);

/// Renames an entry within one disk; a file of the new name is replaced.
void move_entry(const std::filesystem::path& from, const std::filesystem::path& to);

/// Gives a file a second name, or copies it where the disk does not offer that. The first name stays.
void link_or_copy(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace coupling
