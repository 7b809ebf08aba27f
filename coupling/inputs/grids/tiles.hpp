#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/grids/mosaic.hpp"

namespace coupling::grids {

/// How the files of a grid are found and opened; whoever asks for the grid says so.
struct GridFiles {
    /// Where a name leads to.
    std::function<std::filesystem::path(const std::string& name)> path;
    /// The name in messages.
    std::function<std::string(const std::string& name)> shown;
    /// Opens a file of which cells are taken, or which lists such files.
    std::function<FileBytes(const std::string& name, const config::Place& asked_at, bool is_tile)> open;
    /// The files beside it.
    std::function<formats::BytesBeside(const std::string& name, bool is_tile)> beside;
};

/// What the values of a grid are: heights that differ are judged, codes are not.
enum class GridValues { heights, codes };

/// A grid, and what there is to say about it, with names of files.
struct ReadGrid {
    config::Raster<double> raster;
    std::string projection;
    std::vector<std::string> notes;
    std::vector<config::Problem> warnings;
    bool is_mosaic = false;
};

/// Reads the grid that names lead to: one file, or tiles (several files, a folder, a text that lists files, a
/// virtual raster of GDAL). `window` cuts it: tiles outside are not read.
///
/// Tiles are laid side by side by one rule (mosaic.hpp), one after the other: beside the grid there is one
/// tile in memory. Throws InputError for names that lead to no grid and for tiles that do not fit.
ReadGrid read_grid(const std::vector<std::string>& names, const config::Place& asked_at, GridValues values,
                   const std::optional<MapWindow>& window, const GridFiles& files);

}  // namespace coupling::grids
