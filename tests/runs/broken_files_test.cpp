// Twenty files as they come broken: each gets one clear message that says what was found and what to do.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "tests/coupling/inputs/formats/given_files.hpp"
#include "tests/runs/program.hpp"

namespace coupling::broken_files_test {
namespace {

/// The files that a scenario names.
struct Files {
    std::string dem = "dem.tif";
    std::string trees = "layers.gpkg|trees";
    std::string sources = "source = source.tif";
    std::string targets = "road.shp";
};

struct Broken {
    std::string name;
    Files files;
    std::function<void(const SampleProject&)> damage;
    int code;
    std::string message;  ///< of the one line that begins with the file
};

void cut_off(const SampleProject& project, const std::string& name, double share) {
    const std::string bytes = project.read(name);
    project.write(name, bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
}

/// Writes two bytes, the lower one first, behind a sequence that the file must hold.
void patch(const SampleProject& project, const std::string& name, const std::string& behind, unsigned value) {
    const std::string to{static_cast<char>(value & 0xFFU), static_cast<char>(value >> 8U)};
    const std::string bytes = project.read(name);
    const std::size_t at = bytes.find(behind);
    ASSERT_NE(at, std::string::npos);
    project.write(name, bytes.substr(0, at + behind.size()) + to + bytes.substr(at + behind.size() + 2));
}

std::string grid_with_hole(int first_column, int last_column) {
    return "ncols 12\nnrows 10\nxllcorner 1000\nyllcorner 2000\ncellsize 10\nNODATA_value -9999\n" +
           SampleProject::rows([&](int column, int row) {
               const bool hole = column >= first_column && column <= last_column && row >= 3 && row <= 6;
               return std::to_string(hole ? -9999 : 400 - 7 * column);
           });
}

const std::string compression_tag{"\x03\x01\x03\x00\x01\x00\x00\x00", 8};

const std::vector<Broken>& broken_files() {
    static const std::vector<Broken> all{
        {"GeotiffCutOff",
         {},
         [](const auto& p) { cut_off(p, "dem.tif", 0.5); },
         4,
         "dem.tif: found a TIFF that ends before its tags do, expected a complete GeoTIFF; copy or export"},
        {"GeotiffOfUnknownCompression",
         {},
         [](const auto& p) { patch(p, "dem.tif", compression_tag, 34712); },
         4,
         "dem.tif: found compression 34712, expected none, LZW, deflate"},
        {"GeotiffWithoutPlace",
         {},
         [](const auto& p) {
             p.replace("dem.tif", std::string{"\x0E\x83\x0C\x00", 4}, std::string{"\x0D\x83\x0C\x00", 4});
         },
         4,
         "dem.tif: found no place on the map, expected a GeoTIFF"},
        {"EmptyGrid",
         {},
         [](const auto& p) { p.write("dem.tif", ""); },
         4,
         "dem.tif: found an empty file, expected a grid: GeoTIFF or ESRI ASCII; copy or export the file "
         "again"},
        {"PictureForAGrid",
         {},
         [](const auto& p) { p.write("dem.tif", "\x89PNG\r\n\x1a\n and more"); },
         4,
         "dem.tif: found a picture (PNG), expected a grid: GeoTIFF or ESRI ASCII; export the data"},
        {"AsciiGridCutOff",
         {.dem = "dem.asc"},
         [](const auto& p) { cut_off(p, "dem.asc", 0.5); },
         4,
         "values where the file ends, expected 120 (ncols 12 x nrows 10)"},
        {"HoleWhereRocksGo",
         {.dem = "dem.asc", .trees = "none.csv"},
         [](const auto& p) {
             p.write("dem.asc", grid_with_hole(9, 9));
             p.write("none.csv", p.read("trees.csv"));
         },
         0,
         "dem.asc: found 1 hole of NODATA, together 4 cells, the largest of 4 cells from row 4, column 10 (x "
         "1095, "
         "y 2065); rocks that come there leave the terrain, expected heights everywhere inside the rim; fill "
         "the "
         "holes"},
        {"HoleUnderASource",
         {.dem = "dem.asc"},
         [](const auto& p) { p.write("dem.asc", grid_with_hole(2, 2)); },
         4,
         "source.tif: found 4 source cells on NODATA of dem.asc"},
        {"TiffOfThreeBytes",
         {},
         [](const auto& p) { p.write("dem.tif", "II*"); },
         4,
         "dem.tif: found no TIFF behind this ending: it is cut off, damaged or of another kind, expected a "
         "grid: "
         "GeoTIFF or ESRI ASCII; copy or export the file again"},
        {"GeopackageCutOff",
         {},
         [](const auto& p) { cut_off(p, "layers.gpkg", 0.5); },
         4,
         "layers.gpkg|trees: found a damaged GeoPackage"},
        {"GeopackageEncrypted",
         {},
         [](const auto& p) {
             std::string bytes = p.read("layers.gpkg");
             std::transform(bytes.begin(), bytes.end(), bytes.begin(),
                            [](char c) { return static_cast<char>(7 * c + 13); });
             p.write("layers.gpkg", bytes);
         },
         4,
         "layers.gpkg|trees: found no GeoPackage behind this ending: it is encrypted, damaged or of another "
         "kind"},
        {"LayerThatIsNotThere",
         {.trees = "layers.gpkg|tree"},
         [](const auto&) {},
         4,
         "layers.gpkg|tree: found no layer 'tree', expected one of 'trees', 'targets', 'grounds', 'cliff'"},
        {"TwoKindsOfShapeInALayer",
         {.sources = "source_shapes = layers.gpkg|targets"},
         [](const auto&) {},
         4,
         "layers.gpkg|targets:2:2: found another kind of shape than above, expected one kind in a file"},
        {"ShapefileWithoutItsTable",
         {.trees = "trees.shp"},
         [](const auto& p) { p.remove("trees.dbf"); },
         3,
         "trees.shp: found no .dbf beside it, expected a Shapefile with its .shx and .dbf; copy all files"},
        {"ShapefileCutOff",
         {},
         [](const auto& p) { cut_off(p, "road.shp", 0.7); },
         4,
         "road.shp:1:3: found a shape that cannot be read"},
        {"TableOfAShapefileCutOff",
         {},
         [](const auto& p) { cut_off(p, "road.dbf", 0.6); },
         4,
         "bytes, cut off, expected 258 bytes for its 1 rows; export the layer again"},
        {"LayerWithoutCoordinateSystem",
         {},
         [](const auto& p) { p.remove("road.prj"); },
         0,
         "road.shp: names no coordinate system; taken as that of the terrain"},
        {"GeojsonCutOff",
         {.targets = "targets.geojson"},
         [](const auto& p) { cut_off(p, "targets.geojson", 0.5); },
         4,
         "found no valid JSON from here on, expected a complete GeoJSON; copy or export the file again"},
        {"WorkbookForATable",
         {.trees = "trees.csv"},
         [](const auto& p) {
             p.write("trees.csv", std::string{"PK\3\4", 4} + "sheet");
         },
         4,
         "trees.csv: found a ZIP archive, which workbooks of Excel are too"},
        {"TableCutOff",
         {.trees = "trees.csv"},
         [](const auto& p) { cut_off(p, "trees.csv", 0.6); },
         4,
         "fields, expected 6 as in the header"},
        {"WellKnownTextOfOddNumbers",
         {.targets = "targets.csv"},
         [](const auto& p) {
             p.write("targets.csv", "target_id,wkt\nroad,\"LINESTRING (1105 2010, 1105)\"\n");
         },
         4,
         "targets.csv:2:34: found ')', expected the number y"}};
    return all;
}

class BrokenFile : public ::testing::TestWithParam<Broken> {};
INSTANTIATE_TEST_SUITE_P(All, BrokenFile, ::testing::ValuesIn(broken_files()),
                         [](const auto& broken) { return broken.param.name; });

/// Lines of errors; warnings begin with that word.
int errors_in(const std::string& text) {
    int count = 0;
    for (std::size_t at = text.find("bannwald: "); at != std::string::npos;
         at = text.find("bannwald: ", at + 1)) {
        const bool is_error =
            text.compare(at + 10, 8, "warning:") != 0 && text.compare(at + 10, 5, "note:") != 0;
        count += is_error ? 1 : 0;
    }
    return count;
}

TEST_P(BrokenFile, GetsOneClearMessage) {
    const SampleProject project;
    const std::string dem = project.read("dem.asc");
    take_given_files(project);
    project.write("dem.asc", dem);
    project.remove("dem.prj");
    const Files& files = GetParam().files;
    project.write("scenario.ini",
                  "[terrain]\ndem = " + files.dem +
                      "\nsurface = surface.tif\nsurface_types = surface_types.csv\n[trees]\nfile = " +
                      files.trees + "\n[release]\n" + files.sources +
                      "\nrocks_per_source = 5\ndiameter_m = 0.5\n[targets]\nfile = " + files.targets + "\n");
    GetParam().damage(project);
    const Outcome outcome = call(project, "check scenario.ini --verbose");
    EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
    const std::string said = outcome.err + outcome.out;
    EXPECT_NE(said.find(GetParam().message), std::string::npos) << said;
    EXPECT_EQ(errors_in(outcome.err), GetParam().code == 0 ? 0 : 1) << outcome.err;
}

TEST(BrokenFiles, AreTwentyAndMore) {
    EXPECT_GE(broken_files().size(), 20U);
}

}  // namespace
}  // namespace coupling::broken_files_test
