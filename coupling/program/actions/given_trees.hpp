#pragma once

#include <string>

#include "config/table/table.hpp"

namespace coupling {

/// What a project says of a tree list.
struct GivenTrees {
    std::string settings;  ///< lines of [trees] beside the file; empty: none are needed
    std::string remark;    ///< what was found in it, after its name
};

/// Of a list with measured diameters, or of tree tops with heights alone, whose species may be unknown.
/// Throws InputError (data) where a column is missing.
GivenTrees given_trees(config::Table& table);

/// What was found in a layer of stands, read as their polygons and as what grows in them. Throws InputError
/// (data) where a column is missing.
std::string given_stands(config::Table& polygons, config::Table& records);

}  // namespace coupling
