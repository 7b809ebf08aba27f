#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace coupling::rockyfor3d {

/// A project made from a Rockyfor3D folder.
struct Project {
    struct File {
        std::string name;
        std::string text;
    };
    std::vector<File> files;  ///< scenario.ini, dem.asc, ..., README.md
    std::vector<std::string>
        remarks;  ///< what was made of what, and what has no counterpart: a sentence each
};

/// Reads a Rockyfor3D input folder and makes a project of it that runs as it is. Throws InputError as
/// read_folder does.
Project project_of(const std::filesystem::path& folder);

}  // namespace coupling::rockyfor3d
