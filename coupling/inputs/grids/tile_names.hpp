#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/grids/vrt.hpp"

namespace coupling::grids {

/// A tile as a folder, a list or a virtual raster names it.
struct TileName {
    std::string name;                 ///< as a setting could name it
    config::Place asked_at;           ///< where it is named
    std::optional<VrtSource> part{};  ///< of a virtual raster: which of its cells count
};

/// The tiles of a folder in the order of their names, and what else lies there.
struct FolderOfTiles {
    std::vector<TileName> tiles;
    std::size_t others = 0;  ///< files and folders that are no part of a tile
    std::string other;       ///< the first of them
};

/// Whether the ending of a name is that of a grid which may be a tile.
bool is_tile_name(const std::string& name);

/// The grids of a folder by the endings of their names; folders in it are not looked into. `name` is that of
/// the folder, `path` leads to it. Throws InputError (data) where there is none, which says what lies there
/// instead.
FolderOfTiles tiles_of_folder(const std::string& name, const std::filesystem::path& path,
                              const config::Place& asked_at);

/// Whether a text lists files of grids, one a line.
bool is_list_of_tiles(std::string_view text);

/// The files of such a list, from its folder; `#` begins a comment. `shown` is its name in messages.
std::vector<TileName> tiles_of_list(std::string_view text, const std::string& name, const std::string& shown);

/// The sources of a virtual raster, from its folder.
std::vector<TileName> tiles_of_vrt(const VirtualRaster& raster, const std::string& name,
                                   const std::string& shown);

}  // namespace coupling::grids
