#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/program/actions/init_from_files.hpp"

namespace coupling {

/// The heights that are drawn on.
struct DrawingGround {
    std::string system;                               ///< well-known text, "" where they name none
    const config::Raster<double>* heights = nullptr;  ///< null where nothing is known of them
    bool is_sample = false;                           ///< of heights without cells
    double spacing_m = 5.0;
};

/// What a project to draw in has beside one of files: a layer for everything that no file was given for.
struct DrawnProject {
    // Lines of the sections of scenario.ini; empty: that section keeps what it has.
    std::string run;
    std::string terrain;
    std::string release;
    std::string targets;
    std::string stands;  ///< with the head of its section
    std::string nets;
    std::vector<GivenProject::File> files;
    std::vector<std::string> printed;  ///< what init says of it, a sentence each
};

/// Of a project without `draw`: nothing.
DrawnProject drawn_project(const GivenFiles& given, const std::filesystem::path& folder,
                           const DrawingGround& ground);

}  // namespace coupling
