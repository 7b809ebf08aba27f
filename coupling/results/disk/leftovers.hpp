#pragma once

#include <filesystem>
#include <vector>

namespace coupling {

/// What processes that were killed left beside a file under temporary names (temporary_beside), on this
/// machine. A process with another number that still runs is at work there: its files are none of these.
std::vector<std::filesystem::path> leftovers_of(const std::filesystem::path& file);

/// Deletes them. Throws config::InputError (file).
void delete_leftovers_of(const std::filesystem::path& file);

}  // namespace coupling
