#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "coupling/decades/records.hpp"

namespace coupling::decades {

/// Writes what a member left, under a temporary name first, renamed when whole. `hash` is that of settings,
/// inputs and version. Throws config::InputError (file) if the disk does not take it.
void write_part(const std::filesystem::path& file, const std::string& hash, const MemberYears& years);

/// Reads it back; nothing if there is no such file. Throws config::InputError (file) if it is cut off or
/// damaged, or if it is of other settings.
std::optional<MemberYears> read_part(const std::filesystem::path& file, const std::string& hash);

/// Whether a whole part of these settings is there. Throws as read_part.
bool has_part(const std::filesystem::path& file, const std::string& hash);

}  // namespace coupling::decades
