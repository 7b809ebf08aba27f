#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/geopackage/package.hpp"

namespace coupling::qgis {

/// A layer of the tree, on a file of the results.
struct TreeLayer {
    enum class Kind { raster, point, line, area, table };
    Kind kind = Kind::table;
    std::string title;
    std::string
        source;         ///< relative to results.qlr, as QGIS names it: file, or file|layername=...|subset=...
    std::string style;  ///< <pipe> or <renderer-v2>, and what else a <maplayer> holds; may be empty
    std::string label;  ///< column whose text stands beside the features; may be empty
    bool shown = false;
};

/// A folder of the tree.
struct TreeGroup {
    std::string title;
    std::vector<TreeLayer> layers;  ///< the first lies on top
    std::vector<TreeGroup> groups;  ///< below the layers
    bool open = false;
};

/// A QGIS layer definition (.qlr): drag it into a map and the whole tree is there. `projection`: well-known
/// text for all layers with places; QGIS does not look for that of their files.
void write_layer_tree(std::ostream& out, const TreeGroup& root, const std::string& projection);

/// A QGIS project (.qgs) with the layers of the tree and their sources relative to it. `extent`: what the map
/// shows first; empty: all.
void write_project(std::ostream& out, const TreeGroup& root, const std::string& projection,
                   const geopackage::Extent& extent);

}  // namespace coupling::qgis
