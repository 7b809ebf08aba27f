#pragma once

#include <filesystem>

#include "coupling/assessments/calibrate/search/search.hpp"

namespace coupling::calibrate {

/// Writes a search as it stands: under a temporary name first, renamed when it is on the disk. Throws
/// config::InputError (file).
void write_search(const std::filesystem::path& file, const SearchState& state);

/// Reads it back. Throws config::InputError (file) if the file is cut off or damaged.
SearchState read_search(const std::filesystem::path& file);

}  // namespace coupling::calibrate
