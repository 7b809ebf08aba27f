#pragma once

#include <string>
#include <string_view>

#include "coupling/inputs/formats/layer.hpp"

namespace coupling::formats {

/// The bytes of a Shapefile, which is several files of one name.
struct ShapefileParts {
    std::string_view shp;
    std::string_view shx;
    std::string_view dbf;
    std::string_view prj;  ///< empty where it is missing
    std::string_view cpg;  ///< name of the encoding of texts; empty where it is missing
};

/// Whether bytes begin as the main file of a Shapefile.
bool is_shapefile(std::string_view bytes);

/// Reads points, lines or polygons with their attributes. Texts are taken by the .cpg, else by the mark in
/// the .dbf, else as UTF-8 where they are that and as Windows-1252 where not. Deleted rows are passed over.
/// The place of a row in messages is `row number:column number`.
///
/// Throws InputError (data) for other kinds of shapes, parts that do not fit to each other, are cut off or
/// damaged, and for encodings that are not known here.
Layer read_shapefile(const ShapefileParts& parts, const std::string& file);

}  // namespace coupling::formats
