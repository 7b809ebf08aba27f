#pragma once

#include <filesystem>

#include "validation/engine/case/case_files.hpp"

namespace coupling::validation {

/// The files of a case in a folder of the disk: where they lie, or a temporary folder for a case that is
/// built into the program, which goes with the object. Throws InputError (file) where none can be made.
class UnpackedCase {
public:
    explicit UnpackedCase(const CaseFiles& files);
    ~UnpackedCase();
    UnpackedCase(const UnpackedCase&) = delete;
    UnpackedCase& operator=(const UnpackedCase&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    bool temporary_;
};

}  // namespace coupling::validation
