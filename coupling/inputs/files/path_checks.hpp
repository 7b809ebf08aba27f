#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coupling {

/// Questions about names that users give. A name that cannot be looked up (too long, a loop of symbolic
/// links, no permission for a folder above it) throws config::InputError (file) naming it: those of the
/// standard library would throw an error that no user understands, or say "no" to it.

/// Whether a file, a folder or anything else has this name.
bool path_exists(const std::filesystem::path& path);

/// The same where a link counts as something, whatever it leads to.
bool is_there(const std::filesystem::path& entry);

/// Whether a folder has this name, or a link that leads to one.
bool is_folder(const std::filesystem::path& path);

/// Whether an ordinary file has this name, or a link that leads to one. Not for names that users give: one
/// that cannot be looked up is none.
bool is_file(const std::filesystem::path& path);

/// Whether a folder holds nothing. Requires a folder.
bool is_empty_folder(const std::filesystem::path& folder);

/// Paths of all entries of a folder in the order of their names. Requires a folder.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);

/// Length of a file.
std::uintmax_t bytes_of_file(const std::filesystem::path& file);

/// What to do about a file that is not there: of a path as on Windows, or of several files without a blank
/// behind the comma between them; "" for others.
std::string advice_on_missing(const std::filesystem::path& path);

/// A path as a message shows it: 'in quotes', on one line, however long it is. What tells a file from others
/// stands at its end, which config::in_quotes would cut off.
std::string path_in_quotes(const std::filesystem::path& path);

/// Cuts a file to a length.
void cut_file(const std::filesystem::path& file, std::uintmax_t bytes);

}  // namespace coupling
