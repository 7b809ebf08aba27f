#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coupling::pack {

/// The name of the list of checksums in an archive.
inline constexpr const char* manifest_name = "manifest-sha256.txt";

/// A file of an archive and its SHA-256, 64 hexadecimal digits.
struct ListedFile {
    std::string name;
    std::string sha256;
    friend bool operator==(const ListedFile&, const ListedFile&) = default;
};

/// As `sha256sum` writes it: digits, two blanks, name, a line each.
std::string manifest_text(const std::vector<ListedFile>& files);

/// The same read back. Throws config::InputError (data) at a line that is none; `file` names the archive.
std::vector<ListedFile> read_manifest(std::string_view text, const std::string& file);

}  // namespace coupling::pack
