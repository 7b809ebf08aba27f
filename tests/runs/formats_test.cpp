// The same small project as ASCII grids and CSV and as a GIS hands it over: the same rasters, byte for byte.

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "tests/coupling/inputs/formats/given_files.hpp"
#include "tests/runs/program.hpp"

namespace coupling::formats_test {
namespace {

constexpr const char* settings = " --quiet --set release.rocks=2000 --set output.sample_paths=5 ";

/// A project whose layers are given in several formats; only the road is a target, since a Shapefile holds
/// one kind of shape.
void write_project(const SampleProject& project) {
    take_given_files(project);
    project.remove("dem.prj");
    project.write("grounds.csv",
                  "code,wkt\n3,\"POLYGON ((1000 2000, 1120 2000, 1120 2100, 1000 2100, 1000 2000))\"\n"
                  "1,\"POLYGON ((1000 2000, 1030 2000, 1030 2100, 1000 2100, 1000 2000))\"\n");
    project.write("cliff.csv",
                  "zone,wkt\n1,\"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 2030))\"\n");
    project.write("road.csv", "target_id,name,wkt\nroad,Straße,\"LINESTRING (1105 2010, 1105 2090)\"\n");
}

std::string scenario(const std::string& dem, const std::string& grounds, const std::string& trees,
                     const std::string& sources, const std::string& targets) {
    return "[terrain]\ndem = " + dem + "\n" + grounds +
           "\nsurface_types = surface_types.csv\n[trees]\nfile = " + trees + "\n[release]\n" + sources +
           "\nrocks_per_source = 5\ndiameter_m = 0.5\n[targets]\nfile = " + targets + "\n";
}

Outcome run_and_compare(const SampleProject& project, const std::string& name, const std::string& text) {
    project.write(name + ".ini", text);
    return shell(project,
                 "\"$bannwald\" run " + name + ".ini" + settings + "--out " + name +
                     " && for grid in $(cd first && find rasters -name '*.asc'); do cmp first/$grid " + name +
                     "/$grid || exit 77; done\n"
                     "cmp first/tables/targets.csv " +
                     name + "/tables/targets.csv\n");
}

TEST(Formats, GiveTheSameRastersWhateverTheFilesAre) {
    const SampleProject project;
    write_project(project);
    project.write("first.ini", scenario("dem.asc", "surface = surface.asc", "trees.csv",
                                        "source = source.asc", "road.csv"));
    const Outcome first = call(project, std::string{"run first.ini"} + settings + "--out first");
    ASSERT_EQ(first.code, 0) << first.err;
    ASSERT_TRUE(std::filesystem::exists(project.file("first/rasters/Reach_probability.asc")) ||
                !std::filesystem::is_empty(project.file("first/rasters")));
    for (const auto& [name, text] :
         {std::pair{"tif_gpkg", scenario("dem.tif", "surface = surface.tif", "layers.gpkg|trees",
                                         "source = source.tif", "road.shp")},
          std::pair{"shapes", scenario("dem.tif", "surface_polygons = grounds.shp", "trees.shp",
                                       "source_shapes = cliff.shp", "road.shp")},
          std::pair{"layers",
                    scenario("dem.tif", "surface_polygons = layers.gpkg|grounds", "layers.gpkg|trees",
                             "source_shapes = layers.gpkg|layername=cliff", "road.csv")},
          std::pair{"tables", scenario("dem.asc", "surface_polygons = grounds.csv", "trees.shp",
                                       "source_shapes = cliff.csv", "road.shp")}}) {
        const Outcome outcome = run_and_compare(project, name, text);
        EXPECT_EQ(outcome.code, 0) << name << ": " << outcome.out << outcome.err;
    }
    // Both targets in one layer, as a GeoPackage and GeoJSON may have them.
    project.write("two.csv", project.read("targets.csv"));
    project.write("first.ini", scenario("dem.asc", "surface = surface.asc", "trees.csv",
                                        "source = source.asc", "two.csv"));
    ASSERT_EQ(call(project, std::string{"run first.ini --overwrite"} + settings + "--out first").code, 0);
    project.replace("two.csv", "road,road", "road,Straße");
    project.replace("two.csv", "house,house", "house,Haus");
    ASSERT_EQ(call(project, std::string{"run first.ini --overwrite"} + settings + "--out first").code, 0);
    for (const std::string targets : {"layers.gpkg|targets", "targets.geojson"}) {
        const Outcome outcome =
            run_and_compare(project, "both" + std::to_string(targets.size()),
                            scenario("dem.tif", "surface = surface.tif", "layers.gpkg|trees",
                                     "source = source.tif", targets));
        EXPECT_EQ(outcome.code, 0) << targets << ": " << outcome.out << outcome.err;
    }
}

TEST(Formats, AreReadInEveryTypeAndCompressionThatGdalWrites) {
    const SampleProject project;
    write_project(project);
    if (shell(project, "command -v gdal_translate").code != 0) {
        GTEST_SKIP() << "gdal-bin is not installed";
    }
    const std::string expected = call(project, "info dem.tif").out;
    ASSERT_NE(expected.find("range         323 to 400"), std::string::npos) << expected;
    const std::vector<std::string> layouts{
        "COMPRESS=LZW -co PREDICTOR=2",
        "TILED=YES -co COMPRESS=DEFLATE -co BLOCKXSIZE=16 -co BLOCKYSIZE=16",
        "COMPRESS=NONE",
        "COMPRESS=PACKBITS",
        "COMPRESS=ZSTD",
        "COMPRESS=LZMA",
        "COMPRESS=LERC",
        "TILED=YES",
        "BIGTIFF=YES",
        "ENDIANNESS=BIG",
        "COMPRESS=DEFLATE -co BLOCKYSIZE=1",
        "GEOTIFF_VERSION=1.1",
        "SPARSE_OK=TRUE"};
    for (const std::string type : {"Float32", "Int16", "UInt16", "Int32", "UInt32", "Float64"}) {
        const std::size_t tried = type == "Float32" ? layouts.size() : 2;
        for (const std::string& layout : std::span{layouts}.first(tried)) {
            const Outcome outcome =
                shell(project, "gdal_translate -q -ot " + type + " -co " + layout +
                                   " dem.tif given.tif && \"$bannwald\" info given.tif && rm given.tif\n");
            EXPECT_EQ(outcome.code, 0) << type << ' ' << layout << ": " << outcome.err;
            EXPECT_EQ(outcome.out, expected) << type << ' ' << layout;
        }
    }
    const Outcome bytes = shell(project,
                                "gdal_translate -q -ot Byte dem.tif byte.tif -scale 300 400 0 100 && "
                                "\"$bannwald\" info byte.tif\n");
    EXPECT_NE(bytes.out.find("range         23 to 100"), std::string::npos) << bytes.out << bytes.err;
}

TEST(Formats, TakeNodataScalesMasksAndPointsForWhatTheyAre) {
    const SampleProject project;
    write_project(project);
    if (shell(project, "command -v gdal_translate && command -v gdalwarp").code != 0) {
        GTEST_SKIP() << "gdal-bin is not installed";
    }
    const auto info_after = [&](const std::string& command) {
        const Outcome outcome = shell(project, command + " && \"$bannwald\" info given.tif\n");
        return outcome.out + outcome.err;
    };
    const std::string holes = info_after("gdal_translate -q -a_nodata 323 dem.tif given.tif");
    EXPECT_NE(holes.find("NODATA        8.33 %"), std::string::npos) << holes;
    EXPECT_NE(holes.find("range         330 to 400"), std::string::npos) << holes;
    EXPECT_NE(info_after("gdal_translate -q -mo AREA_OR_POINT=Point dem.tif given.tif")
                  .find("extent        x 1000 to 1120, y 2000 to 2100"),
              std::string::npos);
    EXPECT_NE(
        info_after("gdal_translate -q -a_scale 0.1 dem.tif given.tif").find("cells with a scale of '0.1"),
        std::string::npos);
    EXPECT_NE(info_after("gdal_translate -q -b 1 -b 1 dem.tif given.tif").find("found 2 bands"),
              std::string::npos);
    EXPECT_NE(
        info_after("gdal_translate -q -b 1 -mask 1 --config GDAL_TIFF_INTERNAL_MASK YES dem.tif given.tif")
            .find("a mask beside the cells"),
        std::string::npos);
    EXPECT_NE(info_after("gdal_translate -q -of GTiff -co PROFILE=BASELINE dem.tif given.tif")
                  .find("no place on the map"),
              std::string::npos);
}

TEST(Formats, NameWhatTheyTookForWhat) {
    const SampleProject project;
    project.write("trees.csv",
                  "Nr;Ost;Nord;Baumart;BHD;H\xF6he\r\n1;1060;2050;Wei\xDF"
                  "tanne;32,5;25\r\n"
                  "2;1070;2042;Fi;20;18\r\n3;1080;2061;RBu;41;28\r\n");
    project.write("targets.csv", "WKT,id\n\"LINESTRING (1105 2010, 1105 2090)\",road\n");
    const Outcome outcome = call(project, "check scenario.ini --verbose");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string said = outcome.out + outcome.err;
    EXPECT_NE(said.find("trees.csv: no UTF-8: its letters are taken as Windows-1252"), std::string::npos)
        << said;
    EXPECT_NE(said.find("trees.csv: columns that are read under another name: 'Nr' = tree_id, 'Ost' = x_m, "
                        "'Nord' = y_m, 'Baumart' = species, 'BHD' = dbh_cm, 'H\xC3\xB6he' = height_m"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("targets.csv: column 'id' is taken as target_id"), std::string::npos) << said;
}

}  // namespace
}  // namespace coupling::formats_test
