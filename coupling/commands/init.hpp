#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace coupling {

/// Writes a shipped example into a new or empty folder: whole or nothing. Throws InputError (settings) for a
/// folder that holds anything and for an unknown example, InputError (file) where it cannot write.
void write_example(const std::filesystem::path& folder, const std::string& example);

/// Makes a project from a Rockyfor3D input folder, whole or nothing; returns what became of what and what has
/// no counterpart, a sentence each. Throws InputError as above, and for files that are missing (file) or not
/// plausible (data).
std::vector<std::string> write_from_rockyfor3d(const std::filesystem::path& folder,
                                               const std::filesystem::path& source);

}  // namespace coupling
