#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/formats/read_file.hpp"

namespace coupling {

/// The name of the file beside a file: with another ending (".prj"; a ".gz" at the end of the name does not
/// count), or with more behind the whole name where `ending` begins with a hyphen ("-wal").
///
/// Capitals do not count, as on the systems whose programs write ROAD.SHP with Road.dbf: where the very name
/// is missing, the first file in the order of names that differs from it by capitals only is taken. Without
/// any, the name as it would be written beside this one.
std::filesystem::path path_beside(const std::filesystem::path& file, const std::string& ending);

/// The files of the same name as a file with other endings, such as `.prj`; they stay open as long as this
/// object lives.
class FilesBeside {
public:
    explicit FilesBeside(std::filesystem::path file) : file_{std::move(file)} {}
    /// Refers to this object.
    formats::BytesBeside bytes();
    [[nodiscard]] std::filesystem::path path(const std::string& ending) const {
        return path_beside(file_, ending);
    }

private:
    std::filesystem::path file_;
    std::deque<FileBytes> open_;
};

}  // namespace coupling
