#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace coupling::pack {

/// Checksum and length of a file as it lies on the disk: of a compressed one of its compressed bytes.
struct StoredFile {
    std::string sha256;
    std::uint64_t bytes = 0;
};

/// Throws config::InputError (file) for a file that cannot be read to its end.
StoredFile stored_file(const std::filesystem::path& file);

}  // namespace coupling::pack
