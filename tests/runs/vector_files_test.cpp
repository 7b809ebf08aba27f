// Layers as Shapefiles, KML and GPX: the features and the numbers of the GeoPackage, read back by the program
// and, where it is installed, by GDAL.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "config/text/numbers.hpp"
#include "coupling/inputs/formats/shapefile_layer.hpp"
#include "coupling/results/geopackage/database.hpp"
#include "coupling/results/pack/zip_file.hpp"
#include "tests/coupling/results/markup_checks.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/years.hpp"

namespace coupling::vector_files_test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// EPSG:31287 as ESRI writes it, with its own origin in the sample project.
constexpr const char* lambert =
    "PROJCS[\"MGI_Austria_Lambert\",GEOGCS[\"GCS_MGI\",DATUM[\"D_MGI\",SPHEROID[\"Bessel_1841\",6377397.155,"
    "299.1528128]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]],PROJECTION[\"Lambert_"
    "Conformal_Conic\"],PARAMETER[\"False_Easting\",1000.0],PARAMETER[\"False_Northing\",2000.0],PARAMETER["
    "\"Central_Meridian\",13.3333333333333],PARAMETER[\"Standard_Parallel_1\",49.0],PARAMETER[\"Standard_"
    "Parallel_2\",46.0],PARAMETER[\"Latitude_Of_Origin\",47.5],UNIT[\"Meter\",1.0]]";

constexpr const char* all_files =
    "--set output.shapefile=yes --set output.kml=yes --set output.gpx=yes --set release.rocks=200 --set "
    "output.sample_paths=20 ";

/// A project with a place on the earth and a net.
void prepare(const SampleProject& project) {
    project.write("dem.prj", lambert);
    add_nets(project);
}

/// A layer of results.gpkg without its shapes: names of columns, then rows; numbers as short as they can be
/// read back, empty where nothing is known.
struct Stored {
    std::vector<std::string> columns;
    Rows rows;
};

std::map<std::string, Stored> stored_layers(const std::filesystem::path& file) {
    geopackage::Database database{file, geopackage::Database::Open::to_read};
    std::map<std::string, Stored> layers;
    geopackage::Statement names =
        database.prepare("SELECT table_name FROM gpkg_contents WHERE data_type = 'features'");
    while (names.step()) {
        Stored& layer = layers[names.text(0)];
        geopackage::Statement rows =
            database.prepare("SELECT * FROM " + geopackage::sql_name(names.text(0)) + " ORDER BY fid");
        for (int column = 2; column < rows.columns(); ++column) {
            layer.columns.push_back(rows.name(column));
        }
        while (rows.step()) {
            std::vector<std::string>& row = layer.rows.emplace_back();
            for (int column = 2; column < rows.columns(); ++column) {
                row.push_back(rows.is_null(column)     ? std::string{}
                              : rows.is_number(column) ? config::to_text(rows.number(column))
                                                       : rows.text(column));
            }
        }
    }
    return layers;
}

bool same(const std::string& found, const std::string& expected) {
    const auto number = config::parse_number(expected);
    return number ? config::parse_number(found) == number : found == expected;
}

std::string unescaped(std::string text) {
    for (const auto& [from, to] : {std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&quot;", "\""},
                                   std::pair{"&amp;", "&"}}) {
        text = std::regex_replace(text, std::regex{from}, to);
    }
    return text;
}

/// The rows of a layer in an XML text: `begin` to `end` of each feature, fields by a pattern with the name
/// and the value.
Rows rows_in(const std::string& text, const std::string& begin, const std::string& end,
             const std::regex& field, const std::vector<std::string>& columns) {
    Rows rows;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
        const std::string feature = text.substr(at, text.find(end, at) - at);
        std::vector<std::string>& row = rows.emplace_back(columns.size());
        for (std::sregex_iterator found{feature.begin(), feature.end(), field}, none; found != none;
             ++found) {
            const auto column = std::find(columns.begin(), columns.end(), (*found)[1].str());
            EXPECT_NE(column, columns.end()) << (*found)[1];
            row[static_cast<std::size_t>(column - columns.begin())] = unescaped((*found)[2]);
        }
    }
    return rows;
}

void expect_same(const Rows& found, const Rows& expected, const std::string& what) {
    ASSERT_EQ(found.size(), expected.size()) << what;
    for (std::size_t row = 0; row < expected.size(); ++row) {
        for (std::size_t i = 0; i < expected[row].size(); ++i) {
            ASSERT_TRUE(same(found[row][i], expected[row][i]))
                << what << ", row " << row << ": " << found[row][i] << " for " << expected[row][i];
        }
    }
}

/// The Shapefiles of a layer, one for each kind of shape, row after row; `names`: fields by column.
Rows rows_of_shapefiles(const SampleProject& project, const std::string& layer,
                        const std::vector<std::string>& columns, const config::Table& fields) {
    Rows rows;
    for (const std::string kind : {"", "_points", "_lines", "_areas"}) {
        const std::string name = "out/shapefiles/" + layer + kind;
        if (!std::filesystem::exists(project.file(name + ".shp"))) {
            continue;
        }
        const std::string shp = project.read(name + ".shp"), shx = project.read(name + ".shx"),
                          dbf = project.read(name + ".dbf"), prj = project.read(name + ".prj"),
                          cpg = project.read(name + ".cpg");
        EXPECT_EQ(prj, lambert);
        const formats::Layer read = formats::read_shapefile({shp, shx, dbf, prj, cpg}, name);
        std::vector<std::string> names(columns.size());
        for (std::size_t row = 0; row < fields.rows(); ++row) {
            const auto column = std::find(columns.begin(), columns.end(), fields.text(row, "column"));
            if (fields.text(row, "file") == layer + kind && column != columns.end()) {
                names[static_cast<std::size_t>(column - columns.begin())] = fields.text(row, "field");
            }
        }
        for (std::size_t row = 0; row < read.table.rows(); ++row) {
            rows.emplace_back();
            for (const std::string& field : names) {
                rows.back().push_back(read.table.text(row, field));
            }
        }
    }
    return rows;
}

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        ++count;
    }
    return count;
}

TEST(VectorFiles, HoldTheFeaturesAndNumbersOfTheGeoPackage) {
    const SampleProject project;
    prepare(project);
    const Outcome run = call(project, std::string{"run scenario.ini --quiet "} + all_files);
    ASSERT_EQ(run.code, 0) << run.err;
    const std::map<std::string, Stored> layers = stored_layers(project.file("out/results.gpkg"));
    const config::Table fields = table(project, "out/shapefiles/fields.csv");
    const std::string kml = pack::ZipReader{project.file("out/results.kmz")}.text("doc.kml", 100'000'000);
    const std::string gpx = project.read("out/results.gpx");
    EXPECT_EQ(text_checks::markup_fault(kml), "");
    EXPECT_EQ(text_checks::markup_fault(gpx), "");
    const std::set<std::string> for_the_field{"sources", "targets", "nets", "trajectories"};
    std::size_t numbers = 0;
    std::size_t in_gpx = 0;
    for (const auto& [name, stored] : layers) {
        numbers += stored.rows.size() * stored.columns.size();
        // The road comes before the house in both: lines before areas.
        expect_same(rows_of_shapefiles(project, name, stored.columns, fields), stored.rows, name + ".shp");
        const std::size_t begin = kml.rfind("<Folder>", kml.find("\"#columns_" + name + "\""));
        ASSERT_NE(begin, std::string::npos) << name;
        const std::string folder = kml.substr(begin, kml.find("</Folder>", begin) - begin);
        expect_same(rows_in(folder, "<Placemark>", "</Placemark>",
                            std::regex{"<SimpleData name=\"([^\"]*)\">([^<]*)</SimpleData>"}, stored.columns),
                    stored.rows, name + " in results.kmz");
        if (for_the_field.contains(name)) {
            in_gpx += stored.rows.size();
            Rows found = rows_in(gpx, "<type>" + name + "</type>", "</extensions>",
                                 std::regex{"<ogr:([^>]*)>([^<]*)</ogr:"}, stored.columns);
            expect_same(found, stored.rows, name + " in results.gpx");
        }
    }
    EXPECT_GT(numbers, 1000U);
    EXPECT_EQ(count_of(gpx, "<trk>") + count_of(gpx, "<wpt "), in_gpx);
    for (const char* unit : {"energy_max_kj: ", " kJ\n"}) {
        EXPECT_NE(kml.find(unit), std::string::npos) << unit;
    }
    const std::string listed = project.read("out/summary.json");
    for (const char* file : {"shapefiles/fields.csv", "results.kmz", "results.gpx"}) {
        EXPECT_NE(listed.find(file), std::string::npos) << file;
    }
}

TEST(VectorFiles, LieWhereGdalPutsThem) {
    const SampleProject project;
    prepare(project);
    ASSERT_EQ(call(project, std::string{"run scenario.ini --quiet "} + all_files).code, 0);
    const std::string kml = pack::ZipReader{project.file("out/results.kmz")}.text("doc.kml", 100'000'000);
    const std::size_t nets = kml.find("<Folder>\n<name>Nets</name>");
    const std::size_t at = kml.find("<coordinates>", nets) + std::string{"<coordinates>"}.size();
    const double longitude = std::stod(kml.substr(at));
    const double latitude = std::stod(kml.substr(kml.find(',', at) + 1));
    // 95 m east and 10 m north of the origin of the projection; MGI and WGS 84 lie within some 100 m.
    EXPECT_NEAR(longitude, 13.3333333 + 95.0 / 75'300.0, 0.002);
    EXPECT_NEAR(latitude, 47.5 + 10.0 / 111'200.0, 0.002);
    if (shell(project, "command -v ogr2ogr && command -v ogrinfo").code != 0) {
        GTEST_SKIP() << "gdal-bin is not installed";
    }
    const Outcome place =
        shell(project,
              "ogr2ogr -f CSV -lco GEOMETRY=AS_WKT -t_srs EPSG:4326 -lco SEPARATOR=SEMICOLON "
              "nets_there.csv out/results.gpkg nets && cat nets_there.csv\n");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(place.out, found, std::regex{"LINESTRING \\(([0-9.]+) ([0-9.]+)"}))
        << place.out << place.err;
    constexpr double a_metre_deg = 1e-5;
    EXPECT_NEAR(longitude, std::stod(found[1]), a_metre_deg);
    EXPECT_NEAR(latitude, std::stod(found[2]), a_metre_deg);
    for (const auto& [name, stored] : stored_layers(project.file("out/results.gpkg"))) {
        std::size_t features = 0;
        for (const std::string kind : {"", "_points", "_lines", "_areas"}) {
            const std::string file = "out/shapefiles/" + name + kind + ".shp";
            if (std::filesystem::exists(project.file(file))) {
                const Outcome listing = shell(project, "ogrinfo -ro -al -so " + file);
                EXPECT_EQ(listing.err, "") << file;
                std::smatch count;
                ASSERT_TRUE(std::regex_search(listing.out, count, std::regex{"Feature Count: (\\d+)"}))
                    << file;
                features += std::stoul(count[1]);
            }
        }
        EXPECT_EQ(features, stored.rows.size()) << name;
    }
    EXPECT_EQ(shell(project, "ogrinfo -ro -al -so out/results.gpx | grep -c 'Feature Count'").err, "");
    const Outcome sum =
        shell(project,
              "ogrinfo -ro -q -dialect SQLite -sql 'SELECT sum(energy_max_kj) AS total FROM tracks' "
              "out/results.gpx; ogrinfo -ro -q -dialect SQLite -sql 'SELECT sum(energy_max_kj) AS total "
              "FROM trajectories' out/shapefiles/trajectories.shp 2>&1\n");
    std::vector<double> totals;
    const std::regex total{"total \\(Real\\) = ([0-9.]+)"};
    for (std::sregex_iterator each{sum.out.begin(), sum.out.end(), total}, none; each != none; ++each) {
        totals.push_back(std::stod((*each)[1]));
    }
    SCOPED_TRACE(sum.out + sum.err);
    for (const double each : totals) {
        EXPECT_NEAR(each, totals.front(), 1e-9 * totals.front());
    }
}

TEST(VectorFiles, AreTheSameBytesOnAnyDayAndNumberOfThreads) {
    const SampleProject project;
    prepare(project);
    const std::string run = std::string{"run scenario.ini --quiet "} + all_files;
    ASSERT_EQ(call(project, run + "--threads 1 --out one").code, 0);
    // Times in a zip file have steps of two seconds.
    ASSERT_EQ(
        shell(project, "sleep 2.1\nTZ=Asia/Tokyo \"$bannwald\" " + run + "--threads 3 --out three\n").code,
        0);
    EXPECT_EQ(shell(project,
                    "diff -r one/shapefiles three/shapefiles && cmp one/results.kmz "
                    "three/results.kmz && cmp one/results.gpx three/results.gpx\n")
                  .code,
              0);
    EXPECT_GT(project.read("one/results.gpx").size(), 1000U);
}

TEST(VectorFiles, AreMadeWithoutAGeoPackageBesideThem) {
    const SampleProject project;
    project.remove("dem.prj");
    ASSERT_EQ(call(project,
                   "run scenario.ini --quiet --set release.rocks=50 --set output.geopackage=no --set "
                   "output.shapefile=yes")
                  .code,
              0);
    EXPECT_FALSE(std::filesystem::exists(project.file("out/results.gpkg")));
    EXPECT_FALSE(std::filesystem::exists(project.file("out/results.qlr")));
    EXPECT_TRUE(std::filesystem::exists(project.file("out/shapefiles/trees.shp")));
    EXPECT_FALSE(std::filesystem::exists(project.file("out/shapefiles/trees.prj")));
}

TEST(VectorFiles, GoOverTheYears) {
    const ForestProject project;
    project.write("dem.prj", lambert);
    ASSERT_EQ(
        call(project, std::string{four_members} + "--set output.shapefile=yes --set output.kml=yes").code, 0);
    const std::map<std::string, Stored> layers = stored_layers(project.file("out/results.gpkg"));
    const Stored& trees = layers.at("trees");
    EXPECT_GT(trees.rows.size(), 10U);
    expect_same(
        rows_of_shapefiles(project, "trees", trees.columns, table(project, "out/shapefiles/fields.csv")),
        trees.rows, "trees.shp");
    const std::string kml = pack::ZipReader{project.file("out/results.kmz")}.text("doc.kml", 100'000'000);
    std::size_t features = 0;
    for (const auto& [name, stored] : layers) {
        features += stored.rows.size();
    }
    EXPECT_EQ(count_of(kml, "<Placemark>"), features);
}

}  // namespace
}  // namespace coupling::vector_files_test
