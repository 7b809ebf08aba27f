#include "coupling/inputs/formats/read_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/grid/ascii_grid.hpp"
#include "config/text/encoding.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/geojson_layer.hpp"
#include "coupling/inputs/formats/geopackage_layer.hpp"
#include "coupling/inputs/formats/shapefile_layer.hpp"

namespace coupling::formats {
namespace {

using config::joined;

/// Files that people have and that are none of ours: how they begin, and what to do with them.
struct OtherFile {
    std::string_view begins;
    const char* found;
    const char* advice;
};

constexpr std::array other_files{
    OtherFile{{"PK\3\4", 4},
              "a ZIP archive, which workbooks of Excel, KMZ and packed Shapefiles are",
              "unpack it, or save the sheet as CSV UTF-8"},
    OtherFile{{"\xD0\xCF\x11\xE0", 4},
              "a workbook of Excel or an encrypted document",
              "save the sheet as CSV UTF-8, without a password"},
    OtherFile{{"\x89PNG", 4}, "a picture (PNG)", "export the data themselves, as GeoTIFF"},
    OtherFile{{"\xFF\xD8\xFF", 3}, "a picture (JPEG)", "export the data themselves, as GeoTIFF"},
    OtherFile{{"%PDF", 4}, "a PDF", "export the data themselves"},
    OtherFile{{"LASF", 4}, "a point cloud (LAS, LAZ)", "make a terrain grid of it first"},
    OtherFile{{"\x89HDF", 4}, "a file of HDF5 or NetCDF", "export it as GeoTIFF"},
    OtherFile{{"<?xml", 5}, "XML, such as KML or GML", "export it as GeoPackage"},
    OtherFile{{"<kml", 4}, "KML", "export it as GeoPackage"},
    OtherFile{{"\0\0\x27\x0D", 4}, "an index of a Shapefile", "name the .shp"}};

/// Endings that promise a form of bytes: files of that form have been read when they are looked at.
struct Ending {
    std::string_view ending;
    const char* found;
    const char* advice;
};

constexpr const char* no_tiff = "no TIFF behind this ending: it is cut off, damaged or of another kind";
constexpr std::array endings{
    Ending{".gpkg", "no GeoPackage behind this ending: it is encrypted, damaged or of another kind",
           "save it again without a password (QGIS: Save features as, GeoPackage)"},
    Ending{".tif", no_tiff, "copy or export the file again"},
    Ending{".tiff", no_tiff, "copy or export the file again"},
    Ending{".shp", "no Shapefile behind this ending: it is cut off, damaged or of another kind",
           "copy all files of that name again"}};

bool ends_as_geopackage(const std::string& file) {
    return split_layer_name(file).file.ends_with(".gpkg");
}

void refuse_other_files(std::string_view bytes, const std::string& file, const char* expected) {
    if (bytes.empty()) {
        config::fail(config::ExitCode::data, {file}, "an empty file", expected,
                     "copy or export the file again");
    }
    const std::string_view text = config::without_byte_order_mark(bytes);
    for (const OtherFile& other : other_files) {
        if (text.starts_with(other.begins)) {
            config::fail(config::ExitCode::data, {file}, other.found, expected, other.advice);
        }
    }
    const std::string name = config::in_lower_case(split_layer_name(file).file);
    for (const Ending& promised : endings) {
        if (name.ends_with(promised.ending)) {
            config::fail(config::ExitCode::data, {file}, promised.found, expected, promised.advice);
        }
    }
}

bool is_utf16(std::string_view bytes) {
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

constexpr const char* grid_expected = "a grid: GeoTIFF or ESRI ASCII";
constexpr const char* layer_expected = "a table or layer: CSV, GeoPackage, Shapefile or GeoJSON";

}  // namespace

LayerName split_layer_name(const std::string& name) {
    const std::size_t bar = name.find('|');
    if (bar == std::string::npos) {
        return {name, ""};
    }
    std::string layer = name.substr(bar + 1);
    constexpr std::string_view of_qgis = "layername=";
    if (layer.starts_with(of_qgis)) {
        layer = layer.substr(of_qgis.size(), layer.find('|') - of_qgis.size());
    }
    return {name.substr(0, bar), layer};
}

bool is_gis_raster(std::string_view bytes) {
    return is_tiff(bytes);
}

bool is_gis_layer(std::string_view bytes) {
    return is_database(bytes) || is_shapefile(bytes) || is_geojson(bytes);
}

std::string format_in_words(std::string_view bytes) {
    return is_tiff(bytes)        ? "GeoTIFF"
           : is_database(bytes)  ? "layer of a GeoPackage"
           : is_shapefile(bytes) ? "Shapefile"
           : is_geojson(bytes)   ? "GeoJSON"
                                 : "CSV table";
}

PlacedGrid read_grid_file(std::string_view bytes, const std::string& file, const BytesBeside& beside) {
    if (is_tiff(bytes)) {
        PlacedGrid grid = read_geotiff(bytes, file);
        if (grid.projection.empty()) {
            grid.projection = std::string{config::trimmed(beside(".prj"))};
        }
        return grid;
    }
    if (is_gis_layer(bytes)) {
        config::fail(config::ExitCode::data, {file}, joined("a ", format_in_words(bytes)), grid_expected,
                     "name polygons in the setting for polygons or shapes, or turn them into a grid (QGIS: "
                     "Rasterize)");
    }
    refuse_other_files(bytes, file, grid_expected);
    return {config::read_ascii_grid(bytes, file), std::string{beside(".prj")}};
}

ReadLayer read_layer_file(std::string_view bytes, const std::string& layer, const std::string& file,
                          const BytesBeside& beside) {
    if (is_database(bytes)) {
        return {read_geopackage(bytes, layer, file), true, ""};
    }
    if (bytes.empty() || ends_as_geopackage(file)) {
        refuse_other_files(bytes, file, layer_expected);
    }
    if (!layer.empty()) {
        config::fail(config::ExitCode::data, {file},
                     joined("a layer name ", config::in_quotes(layer), " behind a file without layers"),
                     "a GeoPackage", "leave out | and what follows");
    }
    if (is_shapefile(bytes)) {
        const ShapefileParts parts{bytes, beside(".shx"), beside(".dbf"), beside(".prj"), beside(".cpg")};
        for (const auto& [part, ending] : {std::pair{parts.shx, ".shx"}, std::pair{parts.dbf, ".dbf"}}) {
            if (part.empty()) {
                config::fail(config::ExitCode::file, {file}, joined("no ", ending, " beside it"),
                             "a Shapefile with its .shx and .dbf", "copy all files of that name");
            }
        }
        return {read_shapefile(parts, file), true, ""};
    }
    if (is_geojson(bytes)) {
        return {read_geojson(bytes, file), true, ""};
    }
    if (is_tiff(bytes)) {
        config::fail(config::ExitCode::data, {file}, "a raster (TIFF)", layer_expected,
                     "name grids in the setting for grids");
    }
    refuse_other_files(bytes, file, layer_expected);
    if (is_utf16(bytes) || config::is_utf8(bytes)) {
        return {{config::Table::read(bytes, file, config::FirstColumn::may_lack_name), ""}, false, ""};
    }
    const std::string text = config::to_utf8(bytes, config::Encoding::windows_1252);
    return {{config::Table::read(std::string_view{text}, file, config::FirstColumn::may_lack_name), ""},
            false,
            "no UTF-8: its letters are taken as Windows-1252"};
}

}  // namespace coupling::formats
