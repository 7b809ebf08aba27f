// What a run leaves for GIS programs, read with theirs: GDAL is installed where all tests run, and skipped
// with a word elsewhere.

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "config/table/table.hpp"
#include "coupling/results/geopackage/database.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/lambert.hpp"
#include "tests/runs/years.hpp"

namespace coupling::gis_test {
namespace {

/// Rows of each layer and table, and what its projection is called, as ogrinfo tells them.
struct Seen {
    std::string geometry;
    std::size_t rows = 0;
    std::string projection;
};

bool has_gdal(const SampleProject& project) {
    return shell(project, "command -v ogrinfo && command -v gdalinfo").code == 0;
}

std::map<std::string, Seen> seen_by_gdal(const SampleProject& project, const std::string& file) {
    const Outcome told = shell(project, "ogrinfo -ro -al -so " + file);
    EXPECT_EQ(told.code, 0);
    EXPECT_EQ(told.err, "");  // no warning
    EXPECT_EQ(told.out.find("Warning"), std::string::npos) << told.out;
    std::map<std::string, Seen> layers;
    std::istringstream lines{told.out};
    Seen* layer = nullptr;
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (std::regex_match(line, found, std::regex{"Layer name: (.*)"})) {
            layer = &layers[found[1]];
        } else if (std::regex_match(line, found, std::regex{"Geometry: (.*)"}) && layer != nullptr) {
            layer->geometry = found[1];
        } else if (std::regex_match(line, found, std::regex{"Feature Count: (.*)"}) && layer != nullptr) {
            layer->rows = std::stoul(found[1]);
        } else if (std::regex_search(line, found, std::regex{"^PROJCRS\\[\"([^\"]*)\""}) &&
                   layer != nullptr) {
            layer->projection = found[1];
        }
    }
    return layers;
}

std::size_t rows_of(const SampleProject& project, const std::string& name) {
    return table(project, name).rows();
}

std::string answer(const SampleProject& project, const std::string& file, const std::string& sql) {
    geopackage::Database database{project.file(file), geopackage::Database::Open::to_read};
    geopackage::Statement statement = database.prepare(sql);
    return statement.step() ? statement.text(0) : "no row";
}

constexpr const char* static_run =
    "run scenario.ini --quiet --set release.rocks=400 --set output.sample_paths=20 ";

TEST(GisFiles, HoldEveryTableAndLayerForGdal) {
    const SampleProject project;
    project.write("dem.prj", lambert);
    ASSERT_EQ(call(project, static_run).code, 0);
    if (!has_gdal(project)) {
        GTEST_SKIP() << "gdal-bin is not installed";
    }
    const std::map<std::string, Seen> layers = seen_by_gdal(project, "out/results.gpkg");
    const std::map<std::string, std::string> geometries{{"targets", "Unknown (any)"},
                                                        {"sources", "Polygon"},
                                                        {"trajectories", "3D Measured Line String"},
                                                        {"deposits", "3D Point"},
                                                        {"arrivals", "Point"},
                                                        {"tree_hits", "3D Point"},
                                                        {"trees", "Point"},
                                                        {"protection", "None"},
                                                        {"target_arrivals", "None"},
                                                        {"rocks", "None"},
                                                        {"run_out", "None"}};
    for (const auto& [name, geometry] : geometries) {
        ASSERT_TRUE(layers.contains(name)) << name;
        EXPECT_EQ(layers.at(name).geometry, geometry) << name;
        // GDAL knows the text as EPSG:31287 and calls it so.
        EXPECT_EQ(layers.at(name).projection, geometry == "None" ? "" : "MGI / Austria Lambert") << name;
    }
    EXPECT_EQ(layers.at("targets").rows, 2U);
    EXPECT_EQ(layers.at("sources").rows, 4U);
    EXPECT_EQ(layers.at("trees").rows, 3U);
    EXPECT_EQ(layers.at("trajectories").rows, 40U);  // 20 rocks on two slopes
    const config::Table rocks = table(project, "out/tables/rocks.csv");
    std::size_t at_rest = 0;
    for (std::size_t row = 0; row < rocks.rows(); ++row) {
        const std::string& reason = rocks.text(row, "stop_reason");
        at_rest += reason != "left_terrain" && reason != "gave_up" ? 1U : 0U;
    }
    EXPECT_EQ(layers.at("deposits").rows, at_rest);
    for (const auto& entry : std::filesystem::directory_iterator{project.file("out/tables")}) {
        const std::string name = entry.path().stem().string();
        const std::map<std::string, std::string> renamed{
            {"stems", "trees"}, {"targets", "target_arrivals"}, {"trajectories_wkt", "trajectories"}};
        if (name == "trajectories") {
            continue;  // corners, not lines
        }
        const std::string layer = renamed.contains(name) ? renamed.at(name) : name;
        ASSERT_TRUE(layers.contains(layer)) << name;
        EXPECT_EQ(layers.at(layer).rows, rows_of(project, "out/tables/" + entry.path().filename().string()))
            << name;
    }
}

TEST(GisFiles, AreWholeAndTheSameBytesOnAnyNumberOfThreads) {
    const SampleProject project;
    project.write("dem.prj", lambert);
    const std::string all = " --set output.geotiff=yes --set output.vtp=yes ";
    ASSERT_EQ(call(project, static_run + all + "--threads 1").code, 0);
    ASSERT_EQ(call(project, static_run + all + "--threads 3 --out three").code, 0);
    EXPECT_EQ(answer(project, "out/results.gpkg", "PRAGMA integrity_check"), "ok");
    EXPECT_EQ(answer(project, "out/results.gpkg", "PRAGMA foreign_key_check"), "no row");
    for (const std::string file :
         {"results.gpkg", "results.qlr", "trajectories.vtp", "rasters/bare/E_95.tif"}) {
        EXPECT_EQ(project.read("out/" + file), project.read("three/" + file)) << file;
        EXPECT_GT(project.read("out/" + file).size(), 300U) << file;
    }
}

TEST(GisFiles, KeepSumsOfTheTables) {
    const SampleProject project;
    ASSERT_EQ(call(project, static_run).code, 0);
    double energy_kj = 0.0;
    const config::Table stems = table(project, "out/tables/stems.csv");
    for (std::size_t row = 0; row < stems.rows(); ++row) {
        energy_kj += number(stems, row, "energy_kj");
    }
    EXPECT_GT(energy_kj, 0.0);
    EXPECT_NEAR(std::stod(answer(project, "out/results.gpkg", "SELECT sum(energy_kj) FROM trees")), energy_kj,
                1e-6);
    EXPECT_EQ(answer(project, "out/results.gpkg", "SELECT count(*) FROM trees WHERE tree_id = '2'"), "1");
}

TEST(GisFiles, SayThatAPlaceIsUndefinedWithoutAProjection) {
    const SampleProject project;
    project.remove("dem.prj");
    ASSERT_EQ(call(project, static_run).code, 0);
    EXPECT_EQ(answer(project, "out/results.gpkg", "SELECT DISTINCT srs_id FROM gpkg_geometry_columns"), "-1");
}

TEST(GisFiles, AreReadAsRastersByGdal) {
    const SampleProject project;
    project.write("dem.prj", lambert);
    ASSERT_EQ(call(project, std::string{static_run} + "--set output.geotiff=yes").code, 0);
    if (!has_gdal(project)) {
        GTEST_SKIP() << "gdal-bin is not installed";
    }
    const auto told = [&](const std::string& file) {
        const Outcome outcome = shell(project, "gdalinfo -stats " + file);
        EXPECT_EQ(outcome.code, 0) << file;
        EXPECT_EQ(outcome.err, "") << file;
        return outcome.out;
    };
    for (const auto& entry : std::filesystem::directory_iterator{project.file("out/rasters/bare")}) {
        if (entry.path().extension() != ".tif") {
            continue;
        }
        const std::string grid = "out/rasters/bare/" + entry.path().stem().string();
        const std::string tif = told(grid + ".tif");
        const std::string asc = told(grid + ".asc");
        EXPECT_NE(tif.find("MGI_Austria_Lambert"), std::string::npos) << tif;
        EXPECT_NE(tif.find("Origin = (1000.000000000000000,2100.000000000000000)"), std::string::npos) << tif;
        const std::regex mean{"STATISTICS_MEAN=([^\\n]*)"};
        std::smatch in_tif;
        std::smatch in_asc;
        ASSERT_TRUE(std::regex_search(tif, in_tif, mean)) << tif;
        ASSERT_TRUE(std::regex_search(asc, in_asc, mean)) << asc;
        EXPECT_NEAR(std::stod(in_tif[1]), std::stod(in_asc[1]), 1e-5 * std::stod(in_asc[1])) << grid;
    }
}

TEST(GisFiles, GoOverTheYears) {
    const ForestProject project;
    project.write("dem.prj", lambert);
    ASSERT_EQ(call(project, four_members).code, 0);
    EXPECT_EQ(answer(project, "out/results.gpkg", "PRAGMA integrity_check"), "ok");
    std::size_t trees = 0;
    for (const auto& entry : std::filesystem::directory_iterator{project.file("out/tables")}) {
        const std::string name = entry.path().filename().string();
        trees += name.starts_with("trees_") ? rows_of(project, "out/tables/" + name) : 0;
    }
    EXPECT_GT(trees, 0U);
    EXPECT_EQ(answer(project, "out/results.gpkg", "SELECT count(*) FROM trees"), std::to_string(trees));
    EXPECT_EQ(answer(project, "out/results.gpkg", "SELECT count(*) FROM protection"),
              std::to_string(rows_of(project, "out/tables/protection.csv")));
    if (has_gdal(project)) {
        EXPECT_EQ(seen_by_gdal(project, "out/results.gpkg").at("trees").geometry, "Point");
    }
}

TEST(GisFiles, NameInTheLayerTreeOnlyWhatIsThere) {
    const SampleProject project;
    ASSERT_EQ(call(project, static_run).code, 0);
    const std::string tree = project.read("out/results.qlr");
    const std::regex source{"<datasource>\\./([^|<]*)(\\|layername=([a-z_]+))?"};
    std::size_t layers = 0;
    for (std::sregex_iterator at{tree.begin(), tree.end(), source}, end; at != end; ++at, ++layers) {
        EXPECT_TRUE(std::filesystem::exists(project.file("out") / (*at)[1].str())) << (*at)[1];
        if ((*at)[3].matched) {
            EXPECT_EQ(
                answer(project, "out/results.gpkg",
                       "SELECT count(*) FROM gpkg_contents WHERE table_name = '" + (*at)[3].str() + "'"),
                "1");
        }
    }
    EXPECT_GT(layers, 30U);
    EXPECT_EQ(text_checks::markup_fault(tree), "");
    EXPECT_NE(tree.find("<range render=\"true\" symbol=\"1\" lower=\"30\" upper=\"300\""), std::string::npos);
}

}  // namespace
}  // namespace coupling::gis_test
