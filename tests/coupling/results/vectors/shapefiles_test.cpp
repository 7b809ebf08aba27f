#include "coupling/results/vectors/shapefiles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <sstream>

#include "config/table/table.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/formats/geopackage_layer.hpp"
#include "coupling/inputs/formats/shapefile_layer.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::vectors::shapefiles_test {
namespace {

using geopackage::ColumnType;
using geopackage::Database;
using geopackage::Dimensions;
using geopackage::Form;
using geopackage::Geometry;
using geopackage::Plan;
using geopackage::Vertex;
using small_runs::TestFolder;
using small_runs::text_of;

constexpr std::int32_t srs = geopackage::own_reference;

/// One of the Shapefiles in a folder of results, read by the program's own reader.
formats::Layer read_back(const std::filesystem::path& folder, const std::string& name) {
    const auto part = [&](const char* ending) { return text_of(folder / "shapefiles" / (name + ending)); };
    const std::string shp = part(".shp"), shx = part(".shx"), dbf = part(".dbf"), cpg = part(".cpg");
    return formats::read_shapefile({shp, shx, dbf, {}, cpg}, name);
}

Geometry any_geometry(Form form, Dimensions dimensions) {
    const auto any_metres = [] { return 0.001 * *rc::gen::inRange(-1'000'000'000, 1'000'000'000); };
    std::vector<Vertex> corners(form == Form::point ? 1 : static_cast<std::size_t>(*rc::gen::inRange(2, 9)));
    for (Vertex& corner : corners) {
        corner = {any_metres(), any_metres(), any_metres(), any_metres()};
    }
    return form == Form::point ? geopackage::point(corners[0], dimensions, srs)
                               : geopackage::line(corners, dimensions, srs);
}

TEST(Shapefiles, HoldTheFeaturesAndNumbersOfTheGeoPackage) {
    EXPECT_TRUE(rc::check([] {
        const TestFolder folder;
        const std::filesystem::path file = folder.path() / "results.gpkg";
        const Form form = *rc::gen::element(Form::point, Form::line);
        const Dimensions dimensions{.z = *rc::gen::arbitrary<bool>(), .m = false};
        const Plan plan{"rocks_at_nets",
                        "Rocks.",
                        {{"name", ColumnType::text},
                         {"energy_at_the_net_kj", ColumnType::number, "energy", "kJ"},
                         {"energy_at_the_road_kj", ColumnType::number},
                         {"rocks", ColumnType::whole}},
                        form,
                        dimensions};
        std::vector<geopackage::Written> written;
        {
            geopackage::GeoPackage package{file, geopackage::spatial_reference(small_runs::austria_lambert)};
            geopackage::Layer layer{package, plan};
            for (int i = *rc::gen::inRange(1, 12); i > 0; --i) {
                const Geometry geometry = any_geometry(form, dimensions);
                const std::string energy = config::to_text(0.01 * *rc::gen::inRange(0, 10'000'000));
                const std::string other =
                    *rc::gen::arbitrary<bool>() ? "" : config::to_text(1e-5 * *rc::gen::arbitrary<int>());
                const std::string rocks = std::to_string(*rc::gen::arbitrary<int>());
                layer.add({*rc::gen::element<std::string>("Straße", "a, b", "\"c\""), energy, other, rocks},
                          &geometry);
            }
            layer.finish();
            package.close();
            written = package.written();
        }
        Database database{file, Database::Open::to_read};
        write_shapefiles(folder.path(), database, written, small_runs::austria_lambert, {});
        const formats::Layer shapes = read_back(folder.path(), "rocks_at_nets");
        const config::Table stored =
            formats::read_geopackage(text_of(file), "", "results.gpkg", {}).layer.table;
        RC_ASSERT(shapes.table.rows() == stored.rows());
        const std::vector<std::pair<std::string, std::string>> columns{
            {"name", "name"},
            {"energy_at_", "energy_at_the_net_kj"},
            {"energy_a_2", "energy_at_the_road_kj"},
            {"rocks", "rocks"},
            {"wkt", "wkt"}};
        for (std::size_t row = 0; row < stored.rows(); ++row) {
            for (const auto& [field, column] : columns) {
                const std::string found = shapes.table.text(row, field);
                const std::string expected = stored.text(row, column);
                const auto number = config::parse_number(expected);
                const bool is_same = number ? config::parse_number(found) == number : found == expected;
                RC_ASSERT(is_same);
            }
        }
    }));
}

TEST(Shapefiles, TurnRingsAsTheFormatWantsThemAndPartKinds) {
    const TestFolder folder;
    const std::filesystem::path file = folder.path() / "results.gpkg";
    std::vector<geopackage::Written> written;
    {
        geopackage::GeoPackage package{file, geopackage::spatial_reference("")};
        geopackage::Layer layer{package,
                                {"targets", "Targets.", {{"target_id", ColumnType::text}}, Form::mixed, {}}};
        const Geometry house = geopackage::polygons(
            std::vector<std::vector<config::Point2>>{{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}},
                                                     {{2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}}},
            package.srs_id());
        const Geometry road = geopackage::lines(
            std::vector<std::vector<config::Point2>>{{{0, 0}, {1, 1}}, {{5, 5}, {6, 6}, {7, 5}}},
            package.srs_id());
        layer.add({"house"}, &house);
        layer.add({"road"}, &road);
        layer.finish();
        geopackage::Layer table{package, {"notes", "Notes.", {{"note", ColumnType::text}}, Form::none, {}}};
        table.finish();
        package.close();
        written = package.written();
    }
    Database database{file, Database::Open::to_read};
    const WrittenFile listed = write_shapefiles(folder.path(), database, written, "", {});
    EXPECT_EQ(listed.path, "shapefiles/fields.csv");
    EXPECT_EQ(read_back(folder.path(), "targets_areas").table.text(0, "wkt"),
              "POLYGON ((0 0, 0 9, 9 9, 9 0, 0 0), (2 2, 4 2, 4 4, 2 4, 2 2))");
    EXPECT_EQ(read_back(folder.path(), "targets_lines").table.text(0, "wkt"),
              "MULTILINESTRING ((0 0, 1 1), (5 5, 6 6, 7 5))");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "shapefiles/targets_lines.prj"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "shapefiles/notes.dbf"));
    EXPECT_EQ(text_of(folder.path() / "shapefiles/fields.csv"),
              "file,field,column,unit,meaning,cut\ntargets_lines,target_id,target_id,,,no\n"
              "targets_areas,target_id,target_id,,,no\n");
}

}  // namespace
}  // namespace coupling::vectors::shapefiles_test
