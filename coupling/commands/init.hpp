#pragma once

#include <filesystem>
#include <string>

namespace coupling {

/// Writes a shipped example into a new or empty folder: whole or nothing. Throws InputError (settings) for a
/// folder that holds anything and for an unknown example, InputError (file) where it cannot write.
void write_example(const std::filesystem::path& folder, const std::string& example);

}  // namespace coupling
