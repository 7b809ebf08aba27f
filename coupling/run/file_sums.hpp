#pragma once

#include <filesystem>
#include <string>

namespace coupling {

/// `.checksums` in a folder of finished results: length and CRC-64 of each file below it, by name. It finds
/// what changed after the run; it is no protection against malice.
inline constexpr const char* name_of_sums = ".checksums";

/// Writes it, of all files below a folder but hidden ones. Throws config::InputError (file).
void write_sums(const std::filesystem::path& folder);

/// The first file that is no longer as `.checksums` has it, in words: "tables/rocks.csv has changed"; "" if
/// there is none. Throws config::InputError (file) for a file that cannot be read.
std::string changed_file(const std::filesystem::path& folder);

/// Throws config::InputError for a file of finished results, named from their folder, that is no longer as
/// `.checksums` has it (data) or no longer there (file); nothing for one that the run did not write. Results
/// without `.checksums`, such as those of an archive, are taken as they are.
void refuse_changed(const std::filesystem::path& folder, const std::string& name);

}  // namespace coupling
