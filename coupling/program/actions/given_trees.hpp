#pragma once

#include <optional>
#include <string>

#include "config/table/table.hpp"
#include "coupling/program/actions/given_files.hpp"

namespace coupling {

/// What a project says of a tree list.
struct GivenTrees {
    std::string settings;  ///< lines of [trees] beside the file; empty: none are needed
    std::string remark;    ///< what was found in it, after its name
};

/// Of a list with measured diameters, or of tree tops with heights alone, whose species may be unknown.
/// Throws InputError (data) where a column is missing.
GivenTrees given_trees(config::Table& table);

/// What a project says of a canopy raster.
struct GivenCanopy {
    GivenTrees trees;
    std::string system;  ///< its coordinates, "" without any
};

/// Of a raster of vegetation heights; nothing of a file that is no grid. Throws InputError (data) for other
/// values and for cells too wide for crowns.
std::optional<GivenCanopy> given_canopy(GivenFile& file);

/// What was found in a layer of stands, read as their polygons and as what grows in them. Throws InputError
/// (data) where a column is missing.
std::string given_stands(config::Table& polygons, config::Table& records);

}  // namespace coupling
