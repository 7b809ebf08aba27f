#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/results/disk/byte_archive.hpp"

namespace coupling::decades {

/// Writes what a member left, under a temporary name first, renamed when whole. `hash` is that of settings,
/// inputs and version. Throws config::InputError (file) if the disk does not take it.
void write_part(const std::filesystem::path& file, const std::string& hash, const MemberYears& years);

/// Reads back what this member left; nothing if there is no such file. Throws config::InputError (file) if it
/// is cut off or damaged, of other settings, or of another member; the message ends with `remedy`.
std::optional<MemberYears> read_part(const std::filesystem::path& file, const std::string& hash,
                                     const Member& member, const std::string& remedy = own_part_remedy);

/// How each kind of part begins: what it is, and of which run.
void begin_part(ByteWriter& out, std::uint64_t magic_number, const std::string& hash);
/// Throws config::InputError (file) if a part begins otherwise, or if its checksum does not fit.
void check_begin(ByteReader& in, std::uint64_t magic_number, const std::string& hash,
                 const std::filesystem::path& file);

}  // namespace coupling::decades
