#include "coupling/inputs/formats/file_kinds.hpp"

#include <algorithm>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/formats/layer_name.hpp"

namespace coupling::formats {

using config::joined;

namespace {

constexpr std::string_view to_geotiff = "convert it to GeoTIFF (QGIS: Translate; gdal_translate IN dem.tif)";
constexpr std::string_view to_geopackage =
    "convert it to GeoPackage (QGIS: Save features as; ogr2ogr layer.gpkg IN)";
constexpr std::string_view to_metres =
    "transform it to metres (QGIS: Warp; gdalwarp -t_srs EPSG:UTM -r bilinear -dstnodata -9999 IN dem.tif)";
constexpr std::string_view to_roads_and_houses =
    "take roads or houses out of it (ogr2ogr -where \"highway IS NOT NULL\" roads.gpkg IN lines; "
    "ogr2ogr -where \"building IS NOT NULL\" houses.gpkg IN multipolygons)";
constexpr std::string_view layers_of_edigeo =
    "take its layers out of the .THF (ogrinfo lists them; ogr2ogr houses.gpkg IN BATIMENT_id)";
constexpr std::string_view to_csv = "save the sheet as CSV UTF-8";
constexpr std::string_view the_data = "name the file of the data themselves";
constexpr std::string_view not_a_picture = "export the data themselves, as GeoTIFF";
constexpr std::string_view to_grid_of_points =
    "make a grid of its ground points first (pdal translate IN.laz dem.tif range "
    "--filters.range.limits=\"Classification[2:2]\" --writers.gdal.resolution=1 "
    "--writers.gdal.output_type=idw; QGIS: Point cloud, Export to raster using triangulation)";
constexpr std::string_view unpacked = "unpack it and name the file inside";
constexpr std::string_view untarred = "unpack it (tar -xf IN) and name the file inside";
constexpr std::string_view unpacked_bzip2 = "unpack it (bunzip2 -k IN) and name the file inside";
constexpr std::string_view unpacked_or_sheet =
    "unpack it (unzip IN) and name the file inside, or save the sheet of a workbook as CSV";
constexpr std::string_view to_mesh = "export it as PLY, STL or DXF";

/// Stands for every outermost element.
constexpr std::string_view any_root = "*";

using namespace std::string_view_literals;

// Signatures by the published formats; where a format has none, its ending alone stands for it.
constexpr std::array kinds_not_read{
    // Rasters.
    FileKind{"a virtual raster of GDAL (VRT)", to_geotiff, "", 0, "VRTDataset", ""},
    FileKind{"a virtual layer of GDAL (VRT)", to_geopackage, "", 0, "OGRVRTDataSource", ""},
    FileKind{"statistics of a raster (.aux.xml)", the_data, "", 0, "PAMDataset", ""},
    FileKind{"a raster of NetCDF", to_geotiff, "CDF\1"sv, 0, "", ""},
    FileKind{"a raster of NetCDF", to_geotiff, "CDF\2"sv, 0, "", ""},
    FileKind{"a raster of NetCDF", to_geotiff, "CDF\5"sv, 0, "", ""},
    FileKind{"a raster of NetCDF", to_geotiff, "\x89HDF"sv, 0, "", "", {".nc", ".nc4", ".cdf"}},
    FileKind{"a file of HDF5", to_geotiff, "\x89HDF"sv, 0, "", ""},
    FileKind{"a file of HDF4", to_geotiff, "\x0E\x03\x13\x01"sv, 0, "", ""},
    FileKind{"a raster of GRIB", to_geotiff, "GRIB"sv, 0, "", ""},
    FileKind{"a raster of Erdas Imagine (.img)", to_geotiff, "EHFA_HEADER_TAG"sv, 0, "", ""},
    FileKind{"a Surfer grid", to_geotiff, "DSAA"sv, 0, "", ""},
    FileKind{"a Surfer grid", to_geotiff, "DSBB"sv, 0, "", ""},
    FileKind{"a Surfer grid", to_geotiff, "DSRB"sv, 0, "", ""},
    FileKind{"a raster of IDRISI (.rst)", to_geotiff, "", 0, "", "", {".rst", ".rdc"}},
    FileKind{"a raster of PCRaster", to_geotiff, "RUU CROSS SYSTEM MAP FORMAT"sv, 0, "", ""},
    FileKind{"a raster of ENVI", to_geotiff, "ENVI"sv, 0, "", "", {".hdr"}},
    FileKind{"the header of a raster (.hdr)", "name the .flt or .bil beside it", "", 0, "", "", {".hdr"}},
    FileKind{"a raster of SAGA (.sgrd, .sdat)", to_geotiff, "", 0, "", "", {".sgrd", ".sdat", ".sg-grd-z"}},
    FileKind{"a raster of EHdr (.flt, .bil, .bip, .bsq)",
             to_geotiff,
             "",
             0,
             "",
             "",
             {".flt", ".bil", ".bip", ".bsq"}},
    FileKind{"a tile of heights of SRTM (.hgt)", to_metres, "", 0, "", "", {".hgt"}},
    FileKind{"a raster of ArcInfo (.adf)", to_geotiff, "", 0, "", "", {".adf"}},
    FileKind{"a raster of GRD (R, Surfer)", to_geotiff, "", 0, "", "", {".grd", ".gri"}},
    FileKind{"a picture (JPEG 2000)", to_geotiff, "\0\0\0\x0CjP  "sv, 0, "", ""},
    FileKind{"a raster of MrSID", to_geotiff, "msid"sv, 0, "", "", {".sid"}},
    FileKind{"a raster of NITF", to_geotiff, "NITF"sv, 0, "", "", {".ntf", ".nitf"}},
    FileKind{"a raster of DTED", to_geotiff, "UHL1"sv, 0, "", ""},
    FileKind{"a terrain of VTP (.bt)", to_geotiff, "binterr"sv, 0, "", ""},
    FileKind{"a cube of ISIS (.cub)", to_geotiff, "", 0, "", "", {".cub"}},
    FileKind{"a raster of ECW", to_geotiff, "", 0, "", "", {".ecw"}},
    // Layers.
    FileKind{"a layer of FlatGeobuf", to_geopackage, "fgb\3"sv, 0, "", ""},
    FileKind{"a layer of GeoParquet", to_geopackage, "PAR1\x15"sv, 0, "", ""},
    FileKind{"GeoJSON line by line",
             to_geopackage,
             "",
             0,
             "",
             "",
             {".geojsonl", ".geojsons", ".ndjson", ".jsonl"}},
    FileKind{"a map of OpenStreetMap (.osm)", to_roads_and_houses, "", 0, "osm", ""},
    FileKind{"a map of OpenStreetMap (.pbf)", to_roads_and_houses, "\n\tOSMHeader"sv, 4, "", ""},
    FileKind{"a cadastre of France (EDIGEO)", layers_of_edigeo, "", 0, "", "", {".thf"}},
    FileKind{"a part of a cadastre of France (EDIGEO)",
             "name the .THF beside it",
             "BOM"sv,
             0,
             "",
             "",
             {".vec", ".qal", ".geo", ".scd", ".gen", ".dic"}},
    FileKind{"a script of a database (.sql)",
             "export the table as CSV UTF-8 or the layer as GeoPackage",
             "",
             0,
             "",
             "",
             {".sql"}},
    FileKind{"KML, as Google Earth writes it", to_geopackage, "", 0, "kml", ""},
    FileKind{"tracks and waypoints (GPX)", to_geopackage, "", 0, "gpx", ""},
    FileKind{"LandXML", "export it as GeoTIFF, DXF or PLY", "", 0, "LandXML", ""},
    FileKind{"INTERLIS (.xtf)", to_geopackage, "", 0, "TRANSFER", ""},
    FileKind{"GML", to_geopackage, "", 0, "FeatureCollection", ""},
    FileKind{"GML", to_geopackage, "", 0, "", "", {".gml"}},
    FileKind{"a layer of MapInfo (.tab)", to_geopackage, "!table"sv, 0, "", ""},
    FileKind{"a layer of MapInfo (.mif)", to_geopackage, "Version"sv, 0, "", "", {".mif"}},
    FileKind{"a part of a layer of MapInfo",
             "name the .tab in QGIS and save it as GeoPackage",
             "",
             0,
             "",
             "",
             {".mid", ".mif"}},
    FileKind{"a table of dBase (.dbf) alone",
             "name the .shp of a Shapefile, or save the table as CSV UTF-8",
             "",
             0,
             "",
             "",
             {".dbf"}},
    FileKind{
        "an index of a Shapefile", "name the .shp", "", 0, "", "", {".shx", ".sbn", ".sbx", ".qix", ".cpg"}},
    FileKind{"a coordinate system alone (.prj)", the_data, "", 0, "", "", {".prj", ".qpj"}},
    FileKind{"a world file (.tfw)", "name the .tif beside it", "", 0, "", "", {".tfw", ".tifw", ".wld"}},
    FileKind{"the log of a GeoPackage that is open", "name the .gpkg beside it", "\x37\x7F\x06"sv, 0, "", ""},
    FileKind{"the journal of a GeoPackage that is open", "name the .gpkg beside it",
             "\xD9\xD5\x05\xF9\x20\xA1\x63\xD7"sv, 0, "", ""},
    FileKind{"a table of a file geodatabase (.gdbtable)",
             "export the layer as GeoPackage (QGIS opens the .gdb folder)",
             "",
             0,
             "",
             "",
             {".gdbtable", ".gdbtablx"}},
    // Projects and styles, which hold names of data only.
    FileKind{"a project of QGIS", the_data, "", 0, "qgis", "", {".qgs"}},
    FileKind{"a style of QGIS", the_data, "", 0, "qgis", ""},
    FileKind{"a layer definition of QGIS (.qlr)", the_data, "", 0, "qlr", ""},
    FileKind{"a project of QGIS (.qgz)", the_data, "PK\3\4"sv, 0, "", "", {".qgz"}},
    FileKind{"a layer definition of ArcGIS (.lyr)", the_data, "\xD0\xCF\x11\xE0"sv, 0, "", "", {".lyr"}},
    FileKind{"a project of ArcGIS", the_data, "\xD0\xCF\x11\xE0"sv, 0, "", "", {".mxd"}},
    FileKind{"a project of ArcGIS", the_data, "PK\3\4"sv, 0, "", "", {".aprx", ".mapx", ".ppkx", ".lpkx"}},
    FileKind{"a layer definition of ArcGIS (.lyrx)", the_data, "{"sv, 0, "", "CIMLayerDocument"},
    // Archives and documents.
    FileKind{"KMZ, as Google Earth writes it", to_geopackage, "PK\3\4"sv, 0, "", "", {".kmz"}},
    FileKind{"a workbook of Excel (.xlsx)", to_csv, "PK\3\4"sv, 0, "", "", {".xlsx", ".xlsm", ".xltx"}},
    FileKind{"a workbook of Excel (.xlsx)", to_csv, "PK\3\4"sv, 0, "", "xl/workbook"},
    FileKind{"a sheet of LibreOffice (.ods)", to_csv, "PK\3\4"sv, 0, "", "", {".ods", ".fods"}},
    FileKind{"a document of Word (.docx)", "save the table as CSV UTF-8", "PK\3\4"sv, 0, "", "word/document"},
    FileKind{"a Shapefile in a ZIP archive (.shz)", unpacked, "PK\3\4"sv, 0, "", "", {".shz"}},
    FileKind{"a ZIP archive, which workbooks of Excel are too", unpacked_or_sheet, "PK\3\4"sv, 0, "", ""},
    FileKind{"an empty ZIP archive", "copy the archive again", "PK\5\6"sv, 0, "", ""},
    FileKind{"an archive (7z)", unpacked, "7z\xBC\xAF\x27\x1C"sv, 0, "", ""},
    FileKind{"an archive (RAR)", unpacked, "Rar!"sv, 0, "", ""},
    FileKind{"an archive (tar)", untarred, "ustar"sv, 257, "", ""},
    FileKind{"an archive (tar)", untarred, "BZh"sv, 0, "", "", {".tar.bz2", ".tbz", ".tbz2"}},
    FileKind{"an archive (tar)", untarred, "\xFD\x37zXZ"sv, 0, "", "", {".tar.xz", ".txz"}},
    FileKind{"a packed file (bzip2)", unpacked_bzip2, "BZh"sv, 0, "", "", {".bz2"}},
    FileKind{"a packed file (xz)", unpacked, "\xFD\x37zXZ"sv, 0, "", ""},
    FileKind{"a packed file (zstd)", unpacked, "\x28\xB5\x2F\xFD"sv, 0, "", ""},
    FileKind{"a packed file (gzip) inside another", unpacked, "\x1F\x8B"sv, 0, "", ""},
    FileKind{"a document of Word (.doc)",
             "save the table as CSV UTF-8",
             "\xD0\xCF\x11\xE0"sv,
             0,
             "",
             "",
             {".doc"}},
    FileKind{"a workbook of Excel (.xls) or an encrypted document",
             "save the sheet as CSV UTF-8, without a password", "\xD0\xCF\x11\xE0"sv, 0, "", ""},
    FileKind{"a database of Access", "export the table as CSV UTF-8", "Standard Jet"sv, 4, "", ""},
    FileKind{"a database of Access", "export the table as CSV UTF-8", "Standard ACE"sv, 4, "", ""},
    FileKind{"a PDF", "export the data themselves: a PDF holds a drawing of them", "%PDF"sv, 0, "", ""},
    FileKind{"a document (RTF)", "save the table as CSV UTF-8", "{\\rtf"sv, 0, "", ""},
    FileKind{"a web page", "download the file itself: this is a page of the server about it", "", 0, "html",
             ""},
    FileKind{"a pointer to a file (Git LFS)", "fetch the file itself (git lfs pull)",
             "version https://git-lfs"sv, 0, "", ""},
    FileKind{"an object of R (.rds, .RData)", "write it with write.csv or terra::writeRaster", "RDX2\n"sv, 0,
             "", ""},
    FileKind{"an object of R (.rds, .RData)", "write it with write.csv or terra::writeRaster", "RDX3\n"sv, 0,
             "", ""},
    FileKind{"an object of R (.rds, .RData)",
             "write it with write.csv or terra::writeRaster",
             "",
             0,
             "",
             "",
             {".rds", ".rda", ".rdata"}},
    FileKind{"an array of NumPy (.npy)", "write it as GeoTIFF (rasterio) or as an ESRI ASCII grid",
             "\x93NUMPY"sv, 0, "", ""},
    FileKind{"a file of MATLAB (.mat)", "write it as an ESRI ASCII grid or as CSV", "MATLAB 5.0"sv, 0, "",
             ""},
    // Pictures.
    FileKind{"a picture (PNG)", not_a_picture, "\x89PNG"sv, 0, "", ""},
    FileKind{"a picture (JPEG)", not_a_picture, "\xFF\xD8\xFF"sv, 0, "", ""},
    FileKind{"a picture (GIF)", not_a_picture, "GIF8"sv, 0, "", ""},
    FileKind{"a picture (WebP)", not_a_picture, "RIFF"sv, 0, "", "", {".webp"}},
    FileKind{"a picture (BMP)", not_a_picture, "BM"sv, 0, "", "", {".bmp", ".dib"}},
    FileKind{"a drawing (SVG)", "export the data themselves", "", 0, "svg", ""},
    // Point clouds and drawings in three dimensions.
    FileKind{"a point cloud (LAS, LAZ)", to_grid_of_points, "LASF"sv, 0, "", ""},
    FileKind{"a point cloud (E57)", to_grid_of_points, "ASTM-E57"sv, 0, "", ""},
    FileKind{"a point cloud (PCD)", to_grid_of_points, "# .PCD"sv, 0, "", ""},
    FileKind{"a drawing of AutoCAD (.dwg)", "save it as DXF (text)", "AC10"sv, 0, "", "", {".dwg"}},
    FileKind{"a DXF in binary form", "save it as DXF (text)", "AutoCAD Binary DXF"sv, 0, "", ""},
    FileKind{"a drawing of MicroStation (.dgn)", to_geopackage, "", 0, "", "", {".dgn"}},
    FileKind{"a mesh (OBJ)", to_mesh, "", 0, "", "", {".obj"}},
    FileKind{"a mesh (glTF)", to_mesh, "glTF"sv, 0, "", ""},
    FileKind{"a mesh (glTF)", to_mesh, "", 0, "", "", {".gltf", ".glb"}},
    FileKind{"a model of a building (IFC, STEP)", to_mesh, "ISO-10303-21"sv, 0, "", ""},
    // What is XML and none of the above.
    FileKind{"an XML file", "export the data as GeoPackage or GeoTIFF", "", 0, any_root, ""}};

// Read as terrain, not as a grid or a layer. `terrain.mesh` takes them.
constexpr std::string_view as_mesh = "name it as terrain.mesh instead";
constexpr std::string_view dxf_as_mesh =
    "name it as terrain.mesh where it holds the ground; take roads and houses out of it with "
    "ogr2ogr -where \"OGR_GEOMETRY <> 'POINT'\" -a_srs EPSG:CODE layer.gpkg IN, with the code of its system";
constexpr std::array kinds_of_meshes{FileKind{"a mesh (PLY)", as_mesh, "ply\n"sv, 0, "", ""},
                                     FileKind{"a mesh (PLY)", as_mesh, "ply\r"sv, 0, "", ""},
                                     FileKind{"a mesh (STL)", as_mesh, "solid "sv, 0, "", "facet"},
                                     FileKind{"a mesh (STL)", as_mesh, "", 0, "", "", {".stl"}},
                                     FileKind{"a drawing (DXF)", dxf_as_mesh, "", 0, "", "", {".dxf"}},
                                     FileKind{"a drawing (DXF)", dxf_as_mesh, "0\nSECTION"sv, 0, "", ""},
                                     FileKind{"a drawing (DXF)", dxf_as_mesh, "0\r\nSECTION"sv, 0, "", ""}};

constexpr std::array kinds_of_folders{
    FileKind{"a file geodatabase of ESRI (.gdb)",
             "export the layer as GeoPackage (QGIS: Save features as), or the raster as GeoTIFF",
             "",
             0,
             "",
             "",
             {".gdb"}},
    FileKind{"a store of arrays (Zarr)", to_geotiff, "", 0, "", "", {".zarr"}}};

constexpr std::size_t looked_at_bytes = 64 << 10U;

/// The code of UTM in the zone that the name of a tile of SRTM says: N46E007 begins at 7 degrees east.
int utm_of_tile(const std::string& file) {
    const std::string name = config::in_lower_case(file.substr(file.find_last_of('/') + 1));
    const auto digits = [&](std::size_t from, std::size_t count) {
        return config::parse_whole(name.size() > from + count ? name.substr(from, count) : "");
    };
    const auto latitude = digits(1, 2);
    const auto longitude = digits(4, 3);
    constexpr int of_the_alps = 32632;
    if (!latitude || !longitude || (name[0] != 'n' && name[0] != 's') || (name[3] != 'e' && name[3] != 'w')) {
        return of_the_alps;
    }
    const int west_deg = static_cast<int>(name[3] == 'e' ? *longitude : -*longitude);
    constexpr int degrees_of_zone = 6;
    const int zone = (west_deg + 180) / degrees_of_zone + 1;
    return (name[0] == 's' ? 32700 : 32600) + zone;
}

bool begins_with(std::string_view bytes, const FileKind& kind) {
    return bytes.size() >= kind.at && bytes.substr(kind.at).starts_with(kind.begins);
}

bool has_root(std::string_view root, const FileKind& kind) {
    return kind.root.empty() ||
           (!root.empty() && (kind.root == any_root || config::in_lower_case(kind.root) == root));
}

bool holds(std::string_view bytes, std::string_view text) {
    return bytes.substr(0, looked_at_bytes).find(text) != std::string_view::npos ||
           (bytes.size() > looked_at_bytes &&
            bytes.substr(bytes.size() - looked_at_bytes).find(text) != std::string_view::npos);
}

bool has_ending(std::string_view name, const FileKind& kind) {
    return std::any_of(kind.endings.begin(), kind.endings.end(),
                       [&](std::string_view ending) { return !ending.empty() && name.ends_with(ending); });
}

/// The outermost element of XML, without what stands before a colon; empty where the text is no XML.
std::string_view root_of(std::string_view text) {
    text = text.substr(0, looked_at_bytes);
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        if (!text.starts_with('<')) {
            return {};
        }
        const std::string_view end = text.starts_with("<!--") ? "-->" : ">";
        if (text.size() > 1 && (text[1] == '?' || text[1] == '!')) {
            const std::size_t at = text.find(end);
            text.remove_prefix(at == std::string_view::npos ? text.size() : at + end.size());
            continue;
        }
        std::string_view name =
            text.substr(1, std::min<std::size_t>(text.find_first_of(" \t\r\n/>"), 200) - 1);
        const std::size_t colon = name.find(':');
        return colon == std::string_view::npos ? name : name.substr(colon + 1);
    }
}

}  // namespace

std::span<const FileKind> other_file_kinds() {
    return kinds_not_read;
}

namespace {

const FileKind* kind_among(std::span<const FileKind> table, std::string_view bytes, const std::string& name) {
    const std::string_view text = config::without_byte_order_mark(bytes);
    std::string_view from_first_letter = text;
    from_first_letter.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const std::string root = config::in_lower_case(root_of(from_first_letter));
    const std::string low = config::in_lower_case(split_layer_name(name).file);
    const auto found = std::find_if(table.begin(), table.end(), [&](const FileKind& kind) {
        const bool by_bytes =
            begins_with(text, kind) || (kind.at == 0 && begins_with(from_first_letter, kind));
        return by_bytes && (kind.endings.front().empty() || has_ending(low, kind)) && has_root(root, kind) &&
               (kind.holds.empty() || holds(bytes, kind.holds));
    });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace

const FileKind* other_file_kind(std::string_view bytes, const std::string& name) {
    return kind_among(kinds_not_read, bytes, name);
}

const FileKind* mesh_kind(std::string_view bytes, const std::string& name) {
    return kind_among(kinds_of_meshes, bytes, name);
}

const FileKind* folder_kind(const std::string& name) {
    std::string low = config::in_lower_case(name);
    low.erase(low.find_last_not_of('/') + 1);
    const auto* const found = std::find_if(kinds_of_folders.begin(), kinds_of_folders.end(),
                                           [&](const FileKind& kind) { return has_ending(low, kind); });
    return found == kinds_of_folders.end() ? nullptr : found;
}

std::string advice_of(const FileKind& kind, const std::string& file) {
    std::string advice{kind.way_out};
    const auto replace = [&](std::string_view what, const std::string& with) {
        for (std::size_t at = advice.find(what); at != std::string::npos;
             at = advice.find(what, at + with.size())) {
            advice.replace(at, what.size(), with);
        }
    };
    replace("EPSG:UTM", joined("EPSG:", std::to_string(utm_of_tile(split_layer_name(file).file))));
    replace(" IN", joined(" ", split_layer_name(file).file));
    return advice;
}

bool is_utf16(std::string_view bytes) {
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

void refuse_other_file_kinds(std::string_view bytes, const std::string& file, const char* expected) {
    if (bytes.empty()) {
        config::fail(config::ExitCode::data, {file}, "an empty file", expected,
                     "copy or export the file again");
    }
    if (const FileKind* kind = other_file_kind(bytes, file)) {
        config::fail(config::ExitCode::data, {file}, std::string{kind->name}, expected,
                     advice_of(*kind, file));
    }
}

void refuse_unknown_bytes(std::string_view bytes, const std::string& file, const char* expected) {
    constexpr std::size_t beginning = 4096;
    if (!is_utf16(bytes) && bytes.substr(0, beginning).find('\0') != std::string_view::npos) {
        config::fail(config::ExitCode::data, {file}, "a binary file of an unknown kind", expected,
                     "export it again in one of these; gdalinfo or ogrinfo say what it is");
    }
}

}  // namespace coupling::formats
