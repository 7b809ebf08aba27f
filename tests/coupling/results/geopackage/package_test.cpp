#include "coupling/results/geopackage/package.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "config/errors/input_error.hpp"
#include "tests/coupling/results/small_run.hpp"

namespace coupling::geopackage::package_test {
namespace {

using small_runs::TestFolder;

const SpatialReference lambert = spatial_reference(small_runs::austria_lambert);

Plan points() {
    return {"stones",
            "Stones \"and\" blocks.",
            {{"stone_id", ColumnType::text}, {"count", ColumnType::whole}, {"mass_kg", ColumnType::number}},
            Form::point,
            {.z = true}};
}

std::filesystem::path some_stones(const TestFolder& folder) {
    std::filesystem::path file = folder.path() / "stones.gpkg";
    GeoPackage package{file, lambert};
    Layer layer{package, points()};
    const Geometry low = point({177000.0, 376000.0, 800.0}, {.z = true}, package.srs_id());
    const Geometry high = point({177500.0, 376250.0, 900.0}, {.z = true}, package.srs_id());
    layer.add({"7", "3", "12.5"}, &low);
    layer.add({"8", "", ""}, &high);
    layer.finish();
    Layer table{package, {"notes", "Notes.", {{"note", ColumnType::text}}, Form::none, {}}};
    table.add({"it's \"so\""});
    table.finish();
    package.close();
    return file;
}

/// The first column of the first row.
std::string answer(const std::filesystem::path& file, const std::string& sql) {
    Database database{file, Database::Open::to_read};
    Statement statement = database.prepare(sql);
    return statement.step() ? statement.text(0) : "no row";
}

TEST(GeoPackage, IsAWholeDatabaseThatSaysWhatItIs) {
    const TestFolder folder;
    const std::filesystem::path file = some_stones(folder);
    EXPECT_EQ(answer(file, "PRAGMA integrity_check"), "ok");
    EXPECT_EQ(answer(file, "PRAGMA foreign_key_check"), "no row");
    EXPECT_EQ(answer(file, "PRAGMA application_id"), "1196444487");  // GPKG
    EXPECT_EQ(answer(file, "PRAGMA user_version"), "10300");
    EXPECT_EQ(
        answer(file,
               "SELECT group_concat(srs_id) FROM (SELECT srs_id FROM gpkg_spatial_ref_sys ORDER BY srs_id)"),
        "-1,0,4326,100000");
}

TEST(GeoPackage, KeepsValuesOfTheirTypes) {
    const TestFolder folder;
    const std::filesystem::path file = some_stones(folder);
    EXPECT_EQ(
        answer(file,
               "SELECT group_concat(typeof(stone_id) || typeof(count) || typeof(mass_kg), ' ') FROM stones"),
        "textintegerreal textnullnull");
    EXPECT_EQ(answer(file, "SELECT mass_kg FROM stones WHERE stone_id = '7'"), "12.5");
    EXPECT_EQ(answer(file, "SELECT note FROM notes"), "it's \"so\"");
}

TEST(GeoPackage, KnowsTheExtentOfALayerAndFindsWhatLiesInAWindow) {
    const TestFolder folder;
    const std::filesystem::path file = some_stones(folder);
    EXPECT_EQ(answer(file,
                     "SELECT min_x || ' ' || min_y || ' ' || max_x || ' ' || max_y FROM gpkg_contents WHERE "
                     "table_name = "
                     "'stones'"),
              "177000.0 376000.0 177500.0 376250.0");
    EXPECT_EQ(answer(file, "SELECT group_concat(id) FROM rtree_stones_geom WHERE minx > 177400"), "2");
    EXPECT_EQ(answer(file, "SELECT rtreecheck('rtree_stones_geom')"), "ok");
}

TEST(GeoPackage, IsTheSameBytesAgain) {
    const TestFolder first;
    const TestFolder second;
    EXPECT_EQ(small_runs::text_of(some_stones(first)), small_runs::text_of(some_stones(second)));
}

TEST(GeoPackage, NamesTheFileThatCannotBeMade) {
    const TestFolder folder;
    try {
        const GeoPackage package{folder.path() / "missing" / "a.gpkg", {}};
        FAIL() << "made";
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("missing/a.gpkg"), std::string::npos) << error.what();
    }
}

TEST(Database, TellsOfAFullDisk) {
    const TestFolder folder;
    Database database{folder.path() / "full.gpkg", Database::Open::empty};
    database.execute(
        "CREATE TABLE stones (mass REAL); PRAGMA max_page_count = 3;");  // as if the disk ended there
    try {
        for (int i = 0; i < 10'000; ++i) {
            database.execute("INSERT INTO stones VALUES (1.5)");
        }
        FAIL() << "all written";
    } catch (const config::InputError& error) {
        EXPECT_EQ(error.code(), config::ExitCode::file);
        EXPECT_NE(std::string{error.what()}.find("full.gpkg"), std::string::npos);
        EXPECT_NE(std::string{error.what()}.find("No space left"), std::string::npos) << error.what();
    }
}

TEST(SpatialReference, TakesTheNumberOfAnAuthorityAndNeverGuesses) {
    const std::string authority =
        "PROJCS[\"L93\",GEOGCS[\"RGF93\",AUTHORITY[\"EPSG\",\"4171\"]],UNIT[\"m\",1],AUTHORITY[\"EPSG\","
        "\"2154\"]]";
    EXPECT_EQ(spatial_reference(authority).id, 2154);
    EXPECT_EQ(spatial_reference(authority).organization, "EPSG");
    EXPECT_EQ(lambert.id, own_reference);  // the text names no authority
    EXPECT_EQ(lambert.name, "MGI_Austria_Lambert");
    EXPECT_EQ(lambert.definition, small_runs::austria_lambert);
    EXPECT_EQ(spatial_reference("PROJCS[\"x\",GEOGCS[\"RGF93\",AUTHORITY[\"EPSG\",\"4171\"]]]").id,
              own_reference);
    EXPECT_EQ(spatial_reference(" \n").id, -1);
}

std::uint32_t whole_at(const Geometry& geometry, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= static_cast<std::uint32_t>(geometry.bytes.at(at + i)) << (8 * i);
    }
    return value;
}

TEST(Geometry, SaysItsKindAfterTheHeader) {
    constexpr std::size_t header = 8 + 4 * 8;
    const Geometry place = point({1.0, 2.0, 3.0, 4.0}, {.z = true, .m = true}, 2154);
    EXPECT_EQ(place.bytes.size(), header + 5 + 4 * 8);
    EXPECT_EQ(whole_at(place, 4), 2154U);
    EXPECT_EQ(whole_at(place, header + 1), 3001U);
    const std::array<Vertex, 2> ends{Vertex{0.0, 0.0, 1.0}, Vertex{3.0, 4.0, 2.0}};
    EXPECT_EQ(whole_at(line(ends, {.z = true}, -1), header + 1), 1002U);
    EXPECT_EQ(line(ends, {}, -1).extent.high_y_m, 4.0);
}

std::vector<config::Point2> square(double low, double high) {
    return {{low, low}, {high, low}, {high, high}, {low, high}, {low, low}};
}

TEST(Geometry, GivesHolesToTheAreaAroundThem) {
    constexpr std::size_t header = 8 + 4 * 8;
    // An area with a hole, in which another area stands, and an area beside.
    const std::vector<std::vector<config::Point2>> rings{square(0, 10), square(2, 8), square(4, 6),
                                                         square(20, 30)};
    const Geometry areas = polygons(rings, -1);
    EXPECT_EQ(whole_at(areas, header + 1), 6U);
    EXPECT_EQ(whole_at(areas, header + 5), 3U);  // three areas
    const std::size_t first = header + 9;
    EXPECT_EQ(whole_at(areas, first + 5), 2U);  // the first with a hole
    constexpr std::size_t ring_bytes = 4 + 5 * 16;
    EXPECT_EQ(whole_at(areas, first + 9 + 2 * ring_bytes + 5), 1U);
}

/// Points on a spiral, so that no two lie in one place.
std::filesystem::path many_points(const TestFolder& folder, int count) {
    std::filesystem::path file = folder.path() / ("many_" + std::to_string(count) + ".gpkg");
    GeoPackage package{file, lambert};
    Layer layer{package, {"dots", "Dots.", {{"number", ColumnType::whole}}, Form::point, {}}};
    for (int i = 0; i < count; ++i) {
        const Geometry dot =
            point({177000.0 + i * std::cos(0.1 * i), 376000.0 + i * std::sin(0.1 * i)}, {}, package.srs_id());
        layer.add({std::to_string(i)}, &dot);
    }
    layer.finish();
    package.close();
    return file;
}

TEST(PackedIndex, IsSoundForAnyNumberOfRows) {
    const TestFolder folder;
    for (const int count : {0, 1, 15, 16, 17, 51, 52, 2601, 2602, 140'000}) {
        const std::filesystem::path file = many_points(folder, count);
        EXPECT_EQ(answer(file, "SELECT rtreecheck('rtree_dots_geom')"), "ok") << count;
        EXPECT_EQ(answer(file, "PRAGMA integrity_check"), "ok") << count;
        EXPECT_EQ(answer(file, "SELECT count(*) FROM rtree_dots_geom"), std::to_string(count));
        EXPECT_EQ(answer(file, "SELECT count(*) FROM dots"), std::to_string(count));
        EXPECT_EQ(answer(file, "SELECT count(*) FROM dots WHERE number = fid - 1"), std::to_string(count));
    }
}

TEST(PackedIndex, FindsInAWindowWhatLiesThere) {
    const TestFolder folder;
    const std::filesystem::path file = many_points(folder, 20'000);
    for (const double size : {0.5, 10.0, 300.0, 5000.0}) {
        std::size_t inside = 0;
        for (int i = 0; i < 20'000; ++i) {
            const double x = i * std::cos(0.1 * i);
            const double y = i * std::sin(0.1 * i);
            inside += std::abs(x - 1000.0) <= size && std::abs(y) <= size ? 1U : 0U;
        }
        const std::string found = answer(
            file, "SELECT count(*) FROM rtree_dots_geom WHERE maxx >= " + std::to_string(178000.0 - size) +
                      " AND minx <= " + std::to_string(178000.0 + size) + " AND maxy >= " +
                      std::to_string(376000.0 - size) + " AND miny <= " + std::to_string(376000.0 + size));
        // Floats of the index reach a few centimetres beyond the points.
        EXPECT_GE(std::stoul(found), inside) << size;
        EXPECT_LE(std::stoul(found), inside + 5) << size;
    }
}

}  // namespace
}  // namespace coupling::geopackage::package_test
