// Heights in tiles, and several files for one thing: the bytes of the run with one file of all of it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "config/grid/ascii_grid.hpp"
#include "tests/coupling/inputs/grids/tile_files.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/program.hpp"

namespace coupling::tiles_runs_test {
namespace {

/// Runs `SCENARIO.ini` into the folder of that name and compares all grids and tables with those of `first`.
Outcome run_beside_first(const SampleProject& project, const std::string& scenario) {
    return shell(project,
                 "\"$bannwald\" run " + scenario + ".ini --quiet --set release.rocks=2000 --out " + scenario +
                     " || exit 1\nfor file in $(cd first && find rasters tables -name '*.asc' -o -name "
                     "'*.csv'); do cmp first/$file " +
                     scenario + "/$file || exit 77; done\n");
}

/// A sample project with two grounds in polygons, two sources, two targets and two nets in one file each.
class ProjectInParts : public ::testing::Test {
protected:
    ProjectInParts() {
        add_nets(project_);
        project_.write("grounds.csv",
                       "code,wkt\n3,\"POLYGON ((1000 2000, 1120 2000, 1120 2100, 1000 2100, 1000 2000))\"\n"
                       "1,\"POLYGON ((1000 2000, 1030 2000, 1030 2100, 1000 2100, 1000 2000))\"\n");
        project_.write("cliffs.csv",
                       "wkt\n\"LINESTRING (1021 2030, 1022 2048)\"\n\"LINESTRING (1022 2049, 1021 2070)\"\n");
        project_.replace("scenario.ini", "surface = surface.asc", "surface_polygons = grounds.csv");
        project_.replace("scenario.ini", "source = source.asc", "source_shapes = cliffs.csv");
    }
    /// The first run, with which others are compared.
    void run_first() {
        project_.write("first.ini", project_.read("scenario.ini"));
        const Outcome first = call(project_, "run first.ini --quiet --set release.rocks=2000 --out first");
        ASSERT_EQ(first.code, 0) << first.err;
        ASSERT_TRUE(std::filesystem::exists(project_.file("first/tables/targets.csv")));
    }
    /// The run with another value of a setting has the same bytes.
    void expect_same(const std::string& name, const std::string& line, const std::string& other) {
        project_.write(name + ".ini", project_.read("first.ini"));
        project_.replace(name + ".ini", line, other);
        const Outcome outcome = run_beside_first(project_, name);
        EXPECT_EQ(outcome.code, 0) << name << ": " << outcome.out << outcome.err;
    }

    SampleProject project_;
};

TEST_F(ProjectInParts, HasTheBytesOfTheWholeGridFromTilesOfAnyForm) {
    config::Raster<double> heights = config::read_ascii_grid(project_.read("dem.asc"), "dem.asc");
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        heights.values[i] += static_cast<double>(i * 7 % 8) / 8.0;
    }
    project_.write("dem.asc", ascii_text(heights));
    run_first();
    const std::vector<grids::CellWindow> windows = four_windows(heights.frame, {7, 4}, 1);
    std::vector<std::pair<std::string, grids::CellWindow>> tiles;
    for (const std::string& ending : endings_of_tiles()) {
        const std::string folder = "tiles";
        std::filesystem::create_directory(project_.file(folder));
        std::string list;
        tiles.clear();
        for (std::size_t i = 0; i < windows.size(); ++i) {
            const std::string stem = folder + "/" + std::to_string(i);
            write_tile(project_, stem, ending, cut_out(heights, windows[i]));
            tiles.emplace_back(stem + ending, windows[i]);
            list.insert(0, stem + ending + "\n");
        }
        const std::string name = "as_" + ending.substr(1, 3) + (ending == ".asc.gz" ? "_gz" : "");
        project_.write(name + ".txt", list);
        expect_same(name + "_folder", "dem = dem.asc", "dem = " + folder);
        expect_same(name + "_list", "dem = dem.asc", "dem = " + name + ".txt");
        std::filesystem::remove_all(project_.file(folder));
    }
}

TEST_F(ProjectInParts, HasTheBytesOfTheWholeGridFromAVirtualRaster) {
    run_first();
    const config::Raster<double> heights = config::read_ascii_grid(project_.read("dem.asc"), "dem.asc");
    std::vector<std::pair<std::string, grids::CellWindow>> tiles;
    for (const grids::CellWindow& window : four_windows(heights.frame, {5, 6}, 2)) {
        const std::string stem = "tile" + std::to_string(tiles.size());
        write_tile(project_, stem, ".tif", cut_out(heights, window));
        tiles.emplace_back(stem + ".tif", window);
    }
    project_.write("all.vrt", vrt_text(heights.frame, tiles));
    expect_same("virtual", "dem = dem.asc", "dem = all.vrt");
    const Outcome info = call(project_, "info all.vrt");
    EXPECT_EQ(info.code, 0) << info.err;
    EXPECT_NE(info.out.find("virtual raster (VRT)\nframe         12 x 10 cells of 10 m"), std::string::npos)
        << info.out;
    EXPECT_NE(info.out.find("range         323 to 400"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("note          all.vrt: 4 tiles laid side by side"), std::string::npos)
        << info.out;
}

TEST_F(ProjectInParts, HasTheBytesOfGdalsGridFromGdalsDeliveries) {
    if (shell(project_, "command -v gdal_translate && command -v gdalbuildvrt").code != 0) {
        GTEST_SKIP() << "gdal-bin is not installed";
    }
    run_first();
    const Outcome made = shell(project_, R"(
mkdir tif flt bil xyz asc
for part in '0 0 7 5' '6 0 6 6' '0 5 6 5' '6 5 6 5'; do
    name=$(echo $part | tr ' ' _)
    gdal_translate -q -ot Float32 -srcwin $part -of GTiff -co COMPRESS=DEFLATE -co TILED=YES dem.asc tif/$name.tif
    gdal_translate -q -ot Float32 -srcwin $part -of EHdr dem.asc flt/$name.flt
    gdal_translate -q -ot Int16 -srcwin $part -of EHdr dem.asc bil/$name.bil
    gdal_translate -q -srcwin $part -of XYZ dem.asc xyz/$name.xyz
    gdal_translate -q -srcwin $part -of AAIGrid dem.asc asc/$name.asc
done
gzip xyz/*.xyz
for format in tif flt bil xyz asc; do rm -f $format/*.aux.xml; for tile in 0_0_7_5 6_0_6_6; do
    cp dem.prj $format/$tile.prj; done; done
gdalbuildvrt -q all.vrt tif/*.tif
gdal_translate -q -co TFW=YES -co PROFILE=BASELINE dem.asc world.tif
)");
    ASSERT_EQ(made.code, 0) << made.out << made.err;
    project_.write("world.prj", project_.read("dem.prj"));
    for (const std::string name : {"tif", "flt", "bil", "xyz", "asc"}) {
        expect_same("of_" + name, "dem = dem.asc", "dem = " + name);
    }
    expect_same("of_vrt", "dem = dem.asc", "dem = all.vrt");
    expect_same("of_world_file", "dem = dem.asc", "dem = world.tif");
}

TEST_F(ProjectInParts, HasTheBytesOfOneFileFromSeveralForOneThing) {
    run_first();
    const auto split = [&](const std::string& file, const std::string& one, const std::string& other) {
        const std::string text = project_.read(file);
        const std::size_t first = text.find('\n') + 1;
        const std::size_t second = text.find('\n', first) + 1;
        project_.write(one, text.substr(0, second));
        project_.write(other, text.substr(0, first) + text.substr(second));
    };
    split("targets.csv", "road.csv", "houses.csv");
    split("nets.csv", "upper.csv", "lower.csv");
    split("grounds.csv", "below.csv", "above.csv");
    split("cliffs.csv", "north.csv", "south.csv");
    expect_same("two_targets", "file = targets.csv", "file = road.csv, houses.csv");
    expect_same("two_nets", "file = nets.csv", "file = upper.csv, lower.csv");
    expect_same("two_grounds", "= grounds.csv", "= below.csv, above.csv");
    expect_same("two_sources", "= cliffs.csv", "= north.csv, south.csv");
}

TEST_F(ProjectInParts, NamesRowsWithoutAnIdAndCountersByTheirFile) {
    // An empty id, and columns in which a GIS numbers the features of each file.
    struct Ids {
        const char *of_road, *of_houses, *value;
    };
    project_.replace("scenario.ini", "file = targets.csv", "file = road.csv, houses.csv");
    for (const Ids& ids : {Ids{"target_id", "target_id", ""}, Ids{"fid", "OBJECTID", "1"}}) {
        project_.write("road.csv", std::string{ids.of_road} + ",wkt\n" + ids.value +
                                       ",\"LINESTRING (1105 2010, 1105 2090)\"\n");
        project_.write("houses.csv",
                       std::string{ids.of_houses} + ",wkt\n" + ids.value +
                           ",\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\"\n");
        const Outcome outcome =
            call(project_, "run scenario.ini --quiet --overwrite --set release.rocks=100");
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const std::string table = project_.read("out/tables/targets.csv");
        EXPECT_NE(table.find("road_1,"), std::string::npos) << table;
        EXPECT_NE(table.find("houses_1,"), std::string::npos) << table;
    }
}

}  // namespace
}  // namespace coupling::tiles_runs_test
