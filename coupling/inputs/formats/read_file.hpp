#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "coupling/inputs/formats/geotiff.hpp"
#include "coupling/inputs/formats/layer.hpp"
#include "coupling/inputs/formats/layer_name.hpp"

namespace coupling::formats {

/// The bytes of the file of the same name with another ending, such as ".prj", or with more behind the whole
/// name, such as "-wal"; empty where there is none. They live as long as whoever opened it says.
using BytesBeside = std::function<std::string_view(const std::string& ending)>;

/// Reads a grid from the bytes of its file, whatever its format: ESRI ASCII with its .prj, GeoTIFF with its
/// world file where it has no place of its own. Throws InputError, also with what else the bytes are.
PlacedGrid read_grid_file(std::string_view bytes, const std::string& file, const BytesBeside& beside);

/// The text of the world file of a TIFF: `.tfw` as ESRI named it, or one of the longer names; empty: none.
std::string_view world_file_beside(const BytesBeside& beside);

/// Whether a text is rows of three or more numbers, as lists of points are, perhaps below a line of names, or
/// a table with columns for x, y and z and none of trees.
bool is_list_of_points(std::string_view text);

/// What a table of text was read as, where that was not plain UTF-8: a sentence for the user, else empty.
struct ReadLayer {
    Layer layer;
    bool has_shapes_of_its_own = false;  ///< a GIS wrote the shapes: attributes may be older
    std::string remark;
};

/// Reads a table or layer from the bytes of its file, whatever its format: CSV, GeoPackage, Shapefile,
/// GeoJSON. `file` is the name in messages, `layer` may be empty.
ReadLayer read_layer_file(std::string_view bytes, const std::string& layer, const std::string& file,
                          const BytesBeside& beside);

/// Throws InputError (data) with what a file is that ought to be points as text: a grid, a layer, or of a
/// kind that is not read.
void refuse_what_is_no_text_of_points(std::string_view bytes, const std::string& file);

/// "GeoTIFF", "GeoPackage", "CSV table" ...: what the bytes are, for `bannwald info`.
std::string format_in_words(std::string_view bytes);

/// Whether the bytes are a raster or a layer in one of the formats of GIS, not text of ours.
bool is_gis_raster(std::string_view bytes);
bool is_gis_layer(std::string_view bytes);

}  // namespace coupling::formats
