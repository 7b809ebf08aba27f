#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"

namespace coupling {

/// Files of the user to make a project from, as written on the command line; only the heights are needed.
struct GivenFiles {
    std::vector<std::string> dem;      ///< a grid, tiles, points, a mesh or contours
    std::vector<std::string> sources;  ///< a grid of zones, or shapes; empty: cells by their slope
    std::vector<std::string> targets;
    std::string trees;
    std::string stands;                ///< polygons with what grows in them, instead of trees
    std::vector<std::string> grounds;  ///< a grid of codes, or polygons; empty: one ground everywhere
    std::vector<std::string> nets;
    std::vector<std::string> works;
    std::string stops;        ///< where rocks were seen to rest
    std::string scars;        ///< wounds that were seen on stems
    std::string climate;      ///< of a run over years
    std::uint32_t years = 0;  ///< of it; 0: as many as usual
    bool draw = false;        ///< with empty layers for what is not given, to draw in a GIS
};

/// A project that uses the given files where they lie.
struct GivenProject {
    struct File {
        std::string name;
        std::string text;
    };
    std::vector<File> files;           ///< of the new folder
    std::vector<std::string> remarks;  ///< what was taken for what and what is a guess, a sentence each
    /// Why there are no sources, where none were given and no cell is steep enough.
    std::optional<config::Problem> no_sources{};
};

/// Looks into the files and makes a project of them. Throws InputError for files that cannot be read.
GivenProject project_from_files(const GivenFiles& given, const std::filesystem::path& folder);

}  // namespace coupling
