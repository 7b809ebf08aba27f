// Layers of GIS programs as tables: GeoPackage, Shapefile, GeoJSON, CSV.

#include <gtest/gtest.h>

#include "config/geometry/wkt.hpp"
#include "coupling/inputs/formats/geojson_layer.hpp"
#include "coupling/inputs/formats/geopackage_layer.hpp"
#include "coupling/inputs/formats/shapefile_layer.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::layers_test {
namespace {

config::Table table_of(const std::string& bytes, const std::string& layer, const FileParts& parts = {}) {
    return formats::read_layer_file(bytes, layer, "file", beside(parts)).layer.table;
}

std::string refused(const std::string& bytes, const std::string& layer = "", const FileParts& parts = {}) {
    return refusal_of([&] { table_of(bytes, layer, parts); });
}

config::Shape shape_in(const config::Table& table, std::size_t row) {
    return config::read_wkt(table.text(row, "wkt"), {});
}

void expect_targets(const config::Table& table) {
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.text(0, "id"), "road");
    EXPECT_EQ(table.text(0, "name"), "Straße");
    EXPECT_EQ(shape_in(table, 0).kind, config::Shape::Kind::line);
    EXPECT_EQ(shape_in(table, 0).parts.front().back(), (config::Point2{1105, 2090}));
    EXPECT_EQ(shape_in(table, 1).kind, config::Shape::Kind::polygon);
    EXPECT_EQ(shape_in(table, 1).parts.front().size(), 5U);
}

TEST(Geopackage, GivesItsLayersByName) {
    expect_targets(table_of(given_file("layers.gpkg"), "targets"));
    const config::Table trees = table_of(given_file("layers.gpkg"), "trees");
    EXPECT_EQ(trees.text(0, "species"), "Weißtanne");
    EXPECT_EQ(trees.text(0, "dbh_cm"), "32.5");
    EXPECT_EQ(trees.text(2, "wkt"), "POINT (1080 2061)");
    EXPECT_EQ(trees.place(2, "species").line, 3U);  // the number of the feature
}

TEST(Geopackage, NamesItsCoordinateSystem) {
    const auto system = plausible::read_projection(
        formats::read_geopackage(given_file("layers.gpkg"), "trees", "file").layer.projection);
    ASSERT_TRUE(system);
    EXPECT_EQ(system->epsg, 2443);
}

TEST(Geopackage, IsReadWhereAProgramHasItOpen) {
    std::string bytes = given_file("layers.gpkg");
    bytes[18] = bytes[19] = 2;  // new rows go into a file beside it
    expect_targets(table_of(bytes, "targets"));
}

TEST(Geopackage, IsRefusedWhereItIsDamaged) {
    const std::string whole = given_file("layers.gpkg");
    EXPECT_NE(refused(whole.substr(0, 20'000), "trees").find("a damaged GeoPackage"), std::string::npos);
    EXPECT_NE(refused(whole.substr(0, 50), "trees"), "");
    std::string other = whole;
    for (std::size_t at = other.find("gpkg_contents"); at != std::string::npos;
         at = other.find("gpkg_contents", at)) {
        other[at] = 'x';
    }
    EXPECT_NE(refused(other, "trees"), "");
}

TEST(Shapefile, GivesShapesAndAttributes) {
    const FileParts road = given_shapefile("road");
    FileParts with_encoding = road;
    with_encoding[".cpg"] = given_file("road.cpg");
    const config::Table table = table_of(road.at(".shp"), "", with_encoding);
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.text(0, "id"), "road");
    EXPECT_EQ(table.text(0, "name"), "Straße");  // ISO-8859-1 in the file
    EXPECT_EQ(table.text(0, "wkt"), "LINESTRING (1105 2010, 1105 2090)");
    EXPECT_EQ(table_of(road.at(".shp"), "", road).text(0, "name"), "Straße");  // by the bytes themselves

    const FileParts house = given_shapefile("house");
    EXPECT_EQ(shape_in(table_of(house.at(".shp"), "", house), 0).kind, config::Shape::Kind::polygon);
    const FileParts trees = given_shapefile("trees");
    const config::Table points = table_of(trees.at(".shp"), "", trees);
    EXPECT_EQ(points.text(2, "wkt"), "POINT (1080 2061)");
    EXPECT_EQ(points.number(0, "dbh_cm", {}, *std::make_unique<config::Problems>()), 32.5);
    EXPECT_EQ(formats::read_shapefile(
                  {trees.at(".shp"), trees.at(".shx"), trees.at(".dbf"), trees.at(".prj"), ""}, "file")
                  .projection,
              trees.at(".prj"));
}

TEST(Shapefile, IsRefusedWithoutItsParts) {
    FileParts parts = given_shapefile("trees");
    const std::string shp = parts.at(".shp");
    FileParts other = parts;
    other[".dbf"] = given_file("road.dbf");
    EXPECT_NE(refused(shp, "", other).find("found 3 shapes and 1 rows, expected a row for each shape"),
              std::string::npos);
    EXPECT_NE(refused(shp.substr(0, 130), "", parts), "");
    other = parts;
    other[".dbf"].resize(other[".dbf"].size() - 100);
    EXPECT_NE(refused(shp, "", other), "");
}

TEST(Geojson, GivesShapesAndProperties) {
    expect_targets(table_of(given_file("targets.geojson"), ""));
    const auto system =
        plausible::read_projection(formats::read_geojson(given_file("targets.geojson"), "file").projection);
    ASSERT_TRUE(system);
    EXPECT_EQ(system->central_meridian_deg, 129.5);
}

TEST(Geojson, IsOfWgs84WhereItsCoordinatesCanBeDegrees) {
    const std::string text =
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"a":1.5,"b":true,"c":null},)"
        R"("geometry":{"type":"Point","coordinates":[11.5,47.25,900]}}]})";
    const formats::Layer layer = formats::read_geojson(text, "file");
    EXPECT_NE(layer.projection.find("WGS_1984"), std::string::npos);
    EXPECT_EQ(layer.table.text(0, "wkt"), "POINT (11.5 47.25 900)");
    EXPECT_EQ(layer.table.text(0, "a"), "1.5");
    EXPECT_EQ(layer.table.text(0, "b"), "yes");
    EXPECT_EQ(layer.table.text(0, "c"), "");
    std::string far = text;
    far.replace(far.find("11.5"), 4, "1e5");
    EXPECT_EQ(formats::read_geojson(far, "file").projection, "");
}

TEST(TextTable, TakesTheLettersOfWindows) {
    const formats::ReadLayer read =
        formats::read_layer_file("species;dbh_cm\nF\xF6hre;32,5\n", "", "trees.csv", nothing_beside());
    EXPECT_EQ(read.layer.table.text(0, "species"), "Föhre");
    EXPECT_EQ(read.layer.table.text(0, "dbh_cm"), "32.5");
    EXPECT_EQ(read.remark, "no UTF-8: its letters are taken as Windows-1252");
}

}  // namespace
}  // namespace coupling::layers_test
