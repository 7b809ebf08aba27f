#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/program/actions/init_from_files.hpp"

namespace coupling {

/// Writes a shipped example into a new or empty folder: whole or nothing. Throws InputError (settings) for a
/// folder that holds anything and for an unknown example, InputError (file) where it cannot write.
void write_example(const std::filesystem::path& folder, const std::string& example);

/// A project that was made from files.
struct MadeProject {
    std::vector<std::string> remarks;  ///< what became of what, and what is a guess, a sentence each
    config::Warnings warnings;         ///< what `check` says of the project
};

/// Makes a project from a Rockyfor3D input folder, whole or nothing. It is checked as `check` does before it
/// is kept. Throws InputError as above, and for files that are missing (file) or not plausible (data).
MadeProject write_from_rockyfor3d(const std::filesystem::path& folder, const std::filesystem::path& source);

/// Makes a project that uses files of the user, whole or nothing. It is checked as `check` does before it is
/// kept: what is wrong with the files is thrown.
MadeProject write_from_files(const std::filesystem::path& folder, const GivenFiles& given);

}  // namespace coupling
