#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/table/schema.hpp"
#include "coupling/results/figures/colours.hpp"
#include "coupling/results/geopackage/package.hpp"

namespace coupling {

/// A layer that users draw in a GIS. Its columns are those of the tables that its reader declares.
struct DrawingLayer {
    std::string_view name;
    geopackage::Form form = geopackage::Form::none;
    std::string_view title;               ///< in the list of layers of a GIS
    std::string_view sentence;            ///< what a row is and what the run does with it
    std::vector<std::string_view> roles;  ///< of the declared tables; none: lines or areas alone
    Colour colour;
    std::string_view label{};  ///< column whose text stands beside the features
};

inline constexpr const char* drawing_file = "drawing.gpkg";
inline constexpr const char* drawing_map_file = "drawing.qgs";

/// All of them; the first lies on top of a map.
std::span<const DrawingLayer> drawing_layers();
/// Requires a name of one of them.
const DrawingLayer& drawing_layer(std::string_view name);

/// The columns of a layer as their readers declare them, without those of its place.
std::vector<config::ColumnRules> drawing_columns(const DrawingLayer& layer);

/// The bytes of a GeoPackage with these layers, all of them empty, each with what it and its columns mean.
/// `projection`: well-known text of the heights, "" where they name none. The same layers give the same
/// bytes.
std::string empty_drawing(const std::vector<const DrawingLayer*>& layers, const std::string& projection);

/// "drawing.gpkg|nets", as settings name it.
std::string drawing_source(std::string_view layer);

}  // namespace coupling
