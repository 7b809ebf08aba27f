#pragma once

#include <filesystem>
#include <optional>

#include "validation/engine/case/case_files.hpp"

namespace coupling::validation {

/// An empty folder that goes with the object.
class TemporaryFolder {
public:
    /// Throws InputError (file) where none can be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// The files of a case in a folder of the disk: where they lie, or a temporary folder for a case that is
/// built into the program, which goes with the object. Throws InputError (file) where none can be made.
class UnpackedCase {
public:
    explicit UnpackedCase(const CaseFiles& files);

    [[nodiscard]] const std::filesystem::path& path() const {
        return temporary_ ? temporary_->path() : path_;
    }

private:
    std::filesystem::path path_;
    std::optional<TemporaryFolder> temporary_;
};

}  // namespace coupling::validation
