#include "coupling/inputs/grids/tiles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "config/grid/ascii_grid.hpp"
#include "config/text/reading.hpp"
#include "tests/coupling/inputs/grids/tile_files.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling::grids::tiles_test {
namespace {

/// The sample project with its heights in four tiles as well.
class Tiles : public testing::Test {
protected:
    Tiles() : whole_{config::read_ascii_grid(project_.read("dem.asc"), "dem.asc")} {
        std::filesystem::create_directory(project_.file("tiles"));
        const std::string prj = project_.read("dem.prj");
        write_part("tiles/ne.asc", {{7, 0}, 5, 5});
        write_part("tiles/nw.asc", {{0, 0}, 8, 6});
        write_part("tiles/sw.asc", {{0, 5}, 6, 5});
        write_part("tiles/se.asc", {{6, 5}, 6, 5});
        for (const char* tile : {"ne", "nw", "sw", "se"}) {
            project_.write(std::string{"tiles/"} + tile + ".prj", prj);
        }
    }
    void write_part(const std::string& name, const CellWindow& cells) const {
        project_.write(name, ascii_text(cut_out(whole_, cells)));
    }
    [[nodiscard]] Opened opened(const std::string& dem, std::vector<std::string> more = {}) const {
        more.push_back("terrain.dem=" + dem);
        return open(project_, more);
    }
    static bool has(const Opened& opened, const std::string& text) {
        return std::any_of(opened.warnings.begin(), opened.warnings.end(),
                           [&](const std::string& each) { return each.find(text) != std::string::npos; });
    }

    SampleProject project_;
    config::Raster<double> whole_;
};

/// Without the line end that a .prj file may have.
std::string system_text(const Opened& opened) {
    return std::string{config::trimmed(opened.site->projection)};
}

void expect_same_terrain(const Opened& one, const Opened& other) {
    ASSERT_TRUE(one.site) << one.errors;
    ASSERT_TRUE(other.site) << other.errors;
    EXPECT_EQ(one.site->heights.frame, other.site->heights.frame);
    EXPECT_EQ(one.site->heights.values, other.site->heights.values);
    EXPECT_EQ(system_text(one), system_text(other));
    const auto& a = one.site->slope.terrain.vertices();
    const auto& b = other.site->slope.terrain.vertices();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].x_m, b[i].x_m);
        EXPECT_EQ(a[i].y_m, b[i].y_m);
        EXPECT_EQ(a[i].z_m, b[i].z_m);
    }
}

TEST_F(Tiles, GiveTheTerrainOfTheWholeGrid) {
    const Opened whole = open(project_);
    expect_same_terrain(opened("tiles"), whole);
    expect_same_terrain(opened("tiles/"), whole);
    expect_same_terrain(opened("tiles/se.asc, tiles/nw.asc, tiles/ne.asc, tiles/sw.asc"), whole);
    project_.write("list.txt", "# four tiles\ntiles/sw.asc\r\n\ntiles/ne.asc\ntiles/nw.asc\ntiles/se.asc\n");
    expect_same_terrain(opened("list.txt"), whole);
    const Opened tiles = opened("tiles");
    EXPECT_TRUE(has(tiles, "tiles: 4 tiles laid side by side, 12 x 10 cells of 10 m"));
    // Each tile is an input of its own.
    std::size_t tiles_of_dem = 0;
    for (const InputFile& input : tiles.site->inputs) {
        tiles_of_dem += input.role.starts_with("dem tiles/") && input.name.ends_with(".asc") ? 1U : 0U;
    }
    EXPECT_EQ(tiles_of_dem, 4U);
}

// Whatever the cuts, the overlap, the form of each tile and the order of their names.
TEST_F(Tiles, OfAnyCutAndFormGiveTheTerrainOfTheWholeGrid) {
    for (std::size_t i = 0; i < whole_.values.size(); ++i) {
        whole_.values[i] += static_cast<double>(i * 7 % 8) / 8.0;  // as 32-bit floats hold them
    }
    project_.write("dem.asc", ascii_text(whole_));
    const Opened given = open(project_);
    ASSERT_TRUE(given.site) << given.errors;
    std::filesystem::create_directory(project_.file("cut"));
    EXPECT_TRUE(rc::check([&] {
        const config::Cell cut{*rc::gen::inRange(2, whole_.frame.columns - 1),
                               *rc::gen::inRange(2, whole_.frame.rows - 1)};
        const std::vector<CellWindow> windows = four_windows(whole_.frame, cut, *rc::gen::inRange(0, 2));
        std::vector<std::string> names;
        for (std::size_t i = 0; i < windows.size(); ++i) {
            const std::string ending = *rc::gen::elementOf(endings_of_tiles());
            const std::string stem = "cut/" + std::to_string(i);
            write_tile(project_, stem, ending, cut_out(whole_, windows[i]));
            names.push_back(stem + ending);
        }
        std::rotate(names.begin(), names.begin() + *rc::gen::inRange(0, 4), names.end());
        const Opened tiles = opened(names[0] + ", " + names[1] + ", " + names[2] + ", " + names[3]);
        RC_ASSERT(tiles.site != nullptr);
        RC_ASSERT(tiles.site->heights.frame == given.site->heights.frame);
        RC_ASSERT(tiles.site->heights.values == given.site->heights.values);
        RC_ASSERT(system_text(tiles) == system_text(given));
    }));
}

TEST_F(Tiles, OutsideOfTheExtentAreInputsOfWhichNoCellIsTaken) {
    project_.write("tiles/ne.asc", project_.read("tiles/ne.asc").substr(0, 90));  // its cells are cut off
    const std::vector<std::string> extent{"terrain.extent_m=1000, 2000, 1060, 2040",
                                          "release.source=", "release.steeper_than_deg=30",
                                          "targets.file=", "trees.file="};
    const Opened part = opened("tiles", extent);
    ASSERT_TRUE(part.site) << part.errors;
    EXPECT_TRUE(has(part, "1 tile of 4 laid side by side, 6 x 4 cells"));
    // Their places decide where the cells of the others lie: an archive needs them.
    EXPECT_EQ(std::count_if(part.site->inputs.begin(), part.site->inputs.end(),
                            [](const InputFile& one) {
                                return one.name.starts_with("tiles/") && one.name.ends_with(".asc");
                            }),
              4);
    const Opened of_whole = opened("dem.asc", extent);
    expect_same_terrain(part, of_whole);
    EXPECT_TRUE(has(of_whole, "dem.asc: cut to terrain.extent_m, 6 x 4 cells"));
    EXPECT_EQ(opened("tiles").code, config::ExitCode::data);
}

TEST_F(Tiles, ThatOverlapWithOtherHeightsAreNamed) {
    std::string text = project_.read("tiles/ne.asc");
    text.replace(text.find("351"), 3, "356");  // in the column that two tiles have
    project_.write("tiles/ne.asc", text);
    const Opened doubtful = opened("tiles");
    ASSERT_TRUE(doubtful.site) << doubtful.errors;
    EXPECT_TRUE(has(
        doubtful,
        "tiles/ne.asc: found 1 cell of 13 in which tiles overlap with different values, by up to 5 in row "
        "1, column 8"));
    expect_same_terrain(doubtful, open(project_));  // the north-western one counts
    config::Raster<double> higher = cut_out(whole_, {{7, 0}, 5, 5});
    for (double& height_m : higher.values) {
        height_m += 20.0;
    }
    project_.write("tiles/ne.asc", ascii_text(higher));
    EXPECT_NE(opened("tiles").errors.find("take tiles of one model of the ground alone"), std::string::npos);
}

TEST_F(Tiles, LeaveGapsThatAreNamed) {
    write_part("tiles/nw.asc", {{0, 0}, 6, 5});
    write_part("tiles/ne.asc", {{8, 0}, 4, 5});
    const Opened gap = opened("tiles");
    ASSERT_TRUE(gap.site) << gap.errors;
    EXPECT_TRUE(
        has(gap, "tiles: found 10 cells between the tiles that none of them reaches, from row 1, column 7"));
    std::filesystem::remove(project_.file("tiles/ne.asc"));
    write_part("tiles/nw.asc", {{0, 0}, 8, 6});
    EXPECT_TRUE(
        has(opened("tiles"), "tiles: 20 cells beside the tiles, which make no rectangle, are NODATA"));
}

/// The message holds a part; else it is shown.
void expect_refused(const Opened& opened, const std::string& part) {
    EXPECT_NE(opened.errors.find(part), std::string::npos) << "not in: " << opened.errors;
}

TEST_F(Tiles, ThatAreMissingAreNamedByTheirLine) {
    project_.write("list.txt", "tiles/sw.asc\ntiles/gone.asc\n");
    expect_refused(opened("list.txt"), "list.txt:2: found no file 'tiles/gone.asc', ");
}

TEST_F(Tiles, OfAFolderWithoutAnyAreRefused) {
    std::filesystem::create_directory(project_.file("empty"));
    expect_refused(opened("empty"), "found the folder 'empty' without a grid");
    std::filesystem::create_directory(project_.file("empty/deeper"));
    expect_refused(opened("empty"), "the folder 'deeper' in it is not looked into");
}

TEST_F(Tiles, ThatArePointCloudsAreRefusedWithTheWayOut) {
    std::filesystem::create_directory(project_.file("scan"));
    project_.write("scan/cloud.laz", "LASF and more");
    const Opened scan = opened("scan");
    expect_refused(scan, "'cloud.laz': a point cloud (LAS, LAZ)");
    expect_refused(scan, "pdal translate");
}

TEST_F(Tiles, AtOnePlaceAreRefused) {
    write_part("tiles/again.asc", {{6, 5}, 6, 5});
    expect_refused(opened("tiles"), "the very place of");
}

TEST_F(Tiles, OfTwoSystemsAreRefused) {
    const auto zone = [](int number, int meridian_deg) {
        return "PROJCS[\"WGS 84 / UTM zone " + std::to_string(number) +
               "N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,"
               "298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION["
               "\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_"
               "meridian\"," +
               std::to_string(meridian_deg) +
               "],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],PARAMETER["
               "\"false_northing\",0],UNIT[\"metre\",1]]";
    };
    project_.write("tiles/se.prj", zone(32, 9));
    project_.write("tiles/sw.prj", zone(33, 15));
    expect_refused(opened("tiles/se.asc, tiles/sw.asc"), "take tiles of one system");
}

TEST_F(Tiles, InAnotherUnitOfHeightsAreRefused) {
    project_.write("tiles/sw.prj",
                   "COMPD_CS[\"both\"," + project_.read("dem.prj") +
                       ",VERT_CS[\"NAVD88\",VERT_DATUM[\"NAVD88\",2005],UNIT[\"US survey foot\","
                       "0.3048006096012192],AXIS[\"Up\",UP]]]");
    const std::string errors = opened("tiles").errors;
    EXPECT_NE(errors.find("tiles/sw.asc"), std::string::npos) << errors;
    EXPECT_NE(errors.find("0.3048"), std::string::npos) << errors;
}

TEST_F(Tiles, OfAVirtualRasterWithOtherCellsAreRefused) {
    const config::GridFrame& frame = whole_.frame;
    const auto virtual_raster = [&](double cell_m) {
        std::ostringstream text;
        text << std::setprecision(17) << "<VRTDataset rasterXSize=\"6\" rasterYSize=\"5\"><GeoTransform>"
             << frame.x_west_m << ',' << cell_m << ",0," << frame.y_north_m() - 5.0 * frame.cell_height_m
             << ",0," << -cell_m
             << "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename "
                "relativeToVRT=\"1\">tiles/sw.asc</SourceFilename><SourceBand>1</SourceBand>"
                "<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"6\" ySize=\"5\"/>"
                "<DstRect xOff=\"0\" yOff=\"0\" xSize=\"6\" ySize=\"5\"/></SimpleSource></VRTRasterBand>"
                "</VRTDataset>";
        return text.str();
    };
    project_.write("dem.vrt", virtual_raster(2.0 * frame.cell_width_m));
    EXPECT_NE(opened("dem.vrt").errors.find("other cells than dem.vrt gives it"), std::string::npos)
        << opened("dem.vrt").errors;
    project_.write("dem.vrt", virtual_raster(frame.cell_width_m));
    EXPECT_EQ(opened("dem.vrt").errors.find("other cells"), std::string::npos);
}

TEST_F(Tiles, OtherFilesBesideThemArePassedOver) {
    project_.write("tiles/readme.pdf", "%PDF");
    project_.write("tiles/heights.txt", "x");
    const Opened found = opened("tiles");
    ASSERT_TRUE(found.site) << found.errors;
    EXPECT_TRUE(has(found, "tiles: 1 other file in the folder of tiles, such as 'heights.txt', passed over"));
}

TEST_F(Tiles, MayBePointsInRowsAndColumns) {
    project_.write("dem.xyz", points_text(whole_));
    const Opened points = opened("dem.xyz");
    expect_same_terrain(points, open(project_));
    EXPECT_TRUE(
        has(points, "dem.xyz: points in rows and columns, taken as the centres of the cells of a grid"));
}

}  // namespace
}  // namespace coupling::grids::tiles_test
