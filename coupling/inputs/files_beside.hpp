#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "coupling/inputs/file_bytes.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/path_checks.hpp"

namespace coupling {

/// The files of the same name as a file with other endings, such as `.prj`; they stay open as long as this
/// object lives. A `.gz` at the end of the name does not count.
class FilesBeside {
public:
    explicit FilesBeside(std::filesystem::path file) : file_{std::move(file)} {
        if (file_.extension() == ".gz") {
            file_.replace_extension();
        }
    }
    /// Refers to this object.
    formats::BytesBeside bytes() {
        return [this](const std::string& ending) -> std::string_view {
            const std::filesystem::path wanted = path(ending);
            if (!path_exists(wanted)) {
                return {};
            }
            open_.push_back(open_file(wanted, {}, "a readable file"));
            return open_.back().text();
        };
    }
    [[nodiscard]] std::filesystem::path path(const std::string& ending) const {
        return std::filesystem::path{file_}.replace_extension(ending);
    }

private:
    std::filesystem::path file_;
    std::deque<FileBytes> open_;
};

}  // namespace coupling
