#include "coupling/inputs/systems/transform_layer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "config/geometry/wkt.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/formats/system_text.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"

namespace coupling::systems::transform_layer_test {
namespace {

formats::Layer layer_in(const std::string& system, const std::string& wkt) {
    config::Features features{"road.shp", {"wkt", "name"}, {{wkt, "road"}}, {1}};
    return {config::Table::of(std::move(features)), formats::esri_text_of(system)};
}

config::Point2 first_point(const formats::Layer& layer) {
    return config::read_wkt(layer.table.text(0, "wkt"), {}).parts.front().front();
}

// Expected coordinates are those of gdaltransform (GDAL 3.6, PROJ 9.1).
TEST(TransformLayer, MovesShapesAsGdalDoes) {
    formats::Layer layer =
        layer_in("EPSG:25832", "LINESTRING Z (680000 5230000 1234.5, 680100 5230000 1230)");
    const Transformed done = transform_layer(layer, formats::esri_text_of("EPSG:31254"), "dem.tif");
    const config::Point2 point = first_point(layer);
    EXPECT_NEAR(point.x_m, 79'068.3189, 0.05);
    EXPECT_NEAR(point.y_m, 229'408.1997, 0.05);
    EXPECT_NE(layer.table.text(0, "wkt").find(" 1234.5, "), std::string::npos);  // heights stay
    EXPECT_EQ(done.note.find("road.shp: transformed from 'ETRS_1989_UTM_Zone_32N' (EPSG 25832) to "
                             "'MGI_Austria_GK_West' (EPSG 31254) by "),
              0U)
        << done.note;
    EXPECT_NE(done.note.find(", accurate to "), std::string::npos) << done.note;
    EXPECT_EQ(done.warning, "");
    EXPECT_EQ(layer.projection, formats::esri_text_of("EPSG:31254"));
}

// Coordinates are rounded to 0.1 mm both times, and PROJ inverts a change of datum to 0.8 mm here: its small
// angles are no exact rotation.
TEST(TransformLayer, ComesBackToWhereItBeganByLessThanAMillimetre) {
    const std::string utm = formats::esri_text_of("EPSG:25832");
    EXPECT_TRUE(rc::check([&] {
        const std::string system =
            *rc::gen::element<std::string>("EPSG:31287", "EPSG:31254", "EPSG:3035", "EPSG:32632");
        const int east_cm = *rc::gen::inRange(66'000'000, 70'000'000);
        const int north_cm = *rc::gen::inRange(521'000'000, 525'000'000);
        const config::Point2 given{east_cm / 100.0, north_cm / 100.0};
        formats::Layer layer = layer_in(
            "EPSG:25832", "POINT (" + config::to_text(given.x_m) + " " + config::to_text(given.y_m) + ")");
        transform_layer(layer, formats::esri_text_of(system), "dem.tif");
        transform_layer(layer, utm, "dem.tif");
        const config::Point2 back = first_point(layer);
        RC_ASSERT(std::hypot(back.x_m - given.x_m, back.y_m - given.y_m) < 1e-3);
    }));
}

TEST(TransformLayer, KeepsTheFormOfShapes) {
    formats::Layer layer = layer_in(
        "EPSG:31287",
        "MULTIPOLYGON (((250000 370000,250100 370000,250100 370100,250000 370000)),((1 2,3 4,5 6,1 2)))");
    transform_layer(layer, formats::esri_text_of("EPSG:31287"), "dem.tif");  // into itself
    EXPECT_EQ(
        layer.table.text(0, "wkt"),
        "MULTIPOLYGON (((250000 370000,250100 370000,250100 370100,250000 370000)),((1 2,3 4,5 6,1 2)))");
}

// A projection of somebody's own, with a rounded scale, upon a datum in the words of ESRI.
TEST(TransformLayer, FindsTheWayOfAProjectionThatHasNoCode) {
    const std::string own =
        "PROJCS[\"Transverse_Mercator\",GEOGCS[\"GCS_OSGB 1936\",DATUM[\"OSGB_1936\",SPHEROID[\"Airy "
        "1830\",6377563.396,299.3249646]],PRIMEM[\"Greenwich\",0],UNIT[\"Degree\",0.0174532925199433],"
        "AUTHORITY[\"EPSG\",\"4277\"]],PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\","
        "49],"
        "PARAMETER[\"central_meridian\",-2],PARAMETER[\"scale_factor\",0.999601],PARAMETER[\"false_easting\","
        "400000],PARAMETER[\"false_northing\",-100000],UNIT[\"metre\",1]]";
    config::Features features{"houses.shp", {"wkt"}, {{"POINT (529400 181000)"}}, {1}};
    formats::Layer layer{config::Table::of(std::move(features)), own};
    transform_layer(layer, formats::esri_text_of("EPSG:27700"), "dem.tif");
    const config::Point2 point = first_point(layer);
    // The scale alone differs, by 2.7e-7: 3.5 cm in 129 400 m to the east, 7.6 cm in 281 000 m to the north.
    EXPECT_NEAR(point.x_m, 529'400.035, 0.002);
    EXPECT_NEAR(point.y_m, 181'000.076, 0.003);
}

TEST(TransformLayer, RefusesSystemsWithoutADatum) {
    formats::Layer layer = layer_in("EPSG:25832", "POINT (680000 5230000)");
    // As a program writes it that knows the figure of the earth alone.
    layer.projection =
        "PROJCS[\"unknown\",GEOGCS[\"unknown\",DATUM[\"Unknown_based_on_Bessel_1841_ellipsoid\",SPHEROID["
        "\"Bessel "
        "1841\",6377397.155,299.1528128]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
        "PROJECTION["
        "\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",10.25],"
        "PARAMETER["
        "\"scale_factor\",1],PARAMETER[\"false_easting\",1000],PARAMETER[\"false_northing\",-5000000],UNIT["
        "\"metre\",1]]";
    const std::string refused =
        refusal_of([&] { transform_layer(layer, formats::esri_text_of("EPSG:31254"), "dem.tif"); });
    EXPECT_NE(refused.find("road.shp: found coordinates in 'unknown'"), std::string::npos) << refused;
    EXPECT_NE(refused.find("QGIS: Assign projection"), std::string::npos) << refused;
    layer.projection = "PROJCS[\"Sample\"]";
    EXPECT_NE(refusal_of([&] {
                  transform_layer(layer, formats::esri_text_of("EPSG:31254"), "dem.tif");
              }).find("no way is known"),
              std::string::npos);
}

TEST(TransformLayer, RefusesPlacesOutsideOfASystem) {
    formats::Layer layer = layer_in("EPSG:4326", "POINT (11.4 1e8)");
    EXPECT_NE(refusal_of([&] { transform_layer(layer, formats::esri_text_of("EPSG:31254"), "dem.tif"); }),
              "");
}

}  // namespace
}  // namespace coupling::systems::transform_layer_test
