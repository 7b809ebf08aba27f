#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/own_files/file_reader.hpp"

namespace coupling {

/// A file of the user of which only some bytes are wanted, such as the head of a tile of heights that may
/// lie elsewhere. Throws as `open_file`, and config::InputError (file) where the disk does not give what it
/// promised.
class FilePart {
public:
    FilePart(const std::filesystem::path& path, const config::Place& asked_at, std::string_view expected);

    [[nodiscard]] std::uint64_t bytes() const { return reader_->bytes(); }
    /// Reads `count` bytes at a place. Requires that they lie within the file.
    void read(std::uint64_t at, char* to, std::size_t count) const;
    /// The first bytes, fewer in a shorter file.
    [[nodiscard]] std::string beginning(std::size_t most) const;

private:
    std::unique_ptr<FileReader> reader_;
};

}  // namespace coupling
