#include <bit>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"
#include "coupling/assessments/stopping/stopping_recipe.hpp"
#include "coupling/exchange/regimes/fell_list.hpp"
#include "coupling/exchange/regimes/stem_numbers.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/rockyfor3d/project.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/program/actions/info.hpp"
#include "rockfall/terrain/terrain.hpp"
#include "tests/coupling/inputs/meshes/mesh_texts.hpp"
#include "tests/fuzz/subject.hpp"
#include "validation/engine/kinds/validation_case.hpp"

namespace fuzz {
namespace {

using coupling::SampleProject;

/// The file `name` of a project as `bannwald info` shows it.
Subject shown_by_info(const std::string& name, const std::string& bytes) {
    return {"info",
            {name},
            [name, bytes] {
                auto project = std::make_unique<SampleProject>();
                project->write(name, bytes);
                return project;
            },
            [name](const SampleProject& project) {
                std::ostringstream out;
                coupling::write_info(project.file(name).string(), "", out);
            }};
}

/// Four triangles around a point.
rockfall::Terrain pyramid() {
    std::vector<rockfall::Vertex> vertices{
        {0, 0, 400}, {120, 0, 316}, {120, 100, 316}, {0, 100, 400}, {60, 50, 357}};
    constexpr std::uint32_t none = rockfall::no_triangle;
    std::vector<rockfall::Triangle> triangles{{{0, 1, 4}, {none, 1, 3}},
                                              {{1, 2, 4}, {none, 2, 0}},
                                              {{2, 3, 4}, {none, 3, 1}},
                                              {{3, 0, 4}, {none, 0, 2}}};
    return {{1000, 2000}, std::move(vertices), std::move(triangles)};
}

/// Lines of a surveyor; faces stand in a drawing of their own.
constexpr const char* lines_drawing =
    "0\nSECTION\n2\nENTITIES\n0\nPOINT\n10\n1000\n20\n2000\n30\n400\n0\nLINE\n10\n1000\n20\n2010\n30\n399\n11"
    "\n1010\n21\n2010\n31\n398\n0\nLWPOLYLINE\n38\n390\n10\n1000\n20\n2020\n10\n1010\n20\n2020\n10\n1020\n20"
    "\n2021\n0\nPOLYLINE\n70\n8\n0\nVERTEX\n10\n1000\n20\n2030\n30\n380\n0\nVERTEX\n10\n1010\n20\n2030\n30\n3"
    "81\n0"
    "\nSEQEND\n0\nENDSEC\n0\nEOF\n";
/// A face of four corners and one of three.
constexpr const char* faces_drawing =
    "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n10\n1000\n20\n2040\n30\n370\n11\n1010\n21\n2040\n31\n370\n12\n1010\n"
    "22"
    "\n2050\n32\n360\n13\n1000\n23\n2050\n33\n360\n0\n3DFACE\n10\n1010\n20\n2040\n30\n370\n11\n1020\n21\n2045"
    "\n31\n370\n12\n1010\n22\n2050\n32\n360\n13\n1010\n23\n2050\n33\n360\n0\nENDSEC\n0\nEOF\n";

std::vector<Subject> files_of_info() {
    const rockfall::Terrain terrain = pyramid();
    const coupling::meshes::MeshTexts texts{terrain};
    const auto ground = [](double x, double) { return x < 1050 ? 1 : 3; };
    return {
        shown_by_info("slope.ply", texts.ply_with_codes(ground)),
        shown_by_info("binary.ply", texts.binary_ply()),
        shown_by_info("slope.stl", texts.stl()),
        shown_by_info("binary.stl", texts.binary_stl()),
        shown_by_info("lines.dxf", lines_drawing),
        shown_by_info("faces.dxf", faces_drawing),
        shown_by_info(
            "contours.csv",
            "wkt,height_m\n\"LINESTRING (1000 2000, 1010 2000)\",400\n\"LINESTRING Z (1000 2010 390, 1010 "
            "2012 391)\",\nPOINT (1005 2020),380\n"),
        shown_by_info("grid.asc", SampleProject::header() + "NODATA_value -9999\n" +
                                      SampleProject::rows([](int column, int row) {
                                          return column == row ? "-9999" : std::to_string(400.5 - column);
                                      })),
    };
}

/// A table by itself.
Subject table_alone(const std::string& name, const std::string& text,
                    std::function<void(const config::Table&)> take) {
    return {"table",
            {name},
            [name, text] {
                auto project = std::make_unique<SampleProject>();
                project->write(name, text);
                return project;
            },
            [name, take = std::move(take)](const SampleProject& project) {
                const coupling::FileBytes bytes = coupling::open_file(project.file(name), {}, "a table");
                take(config::Table::read(bytes.text(), name));
            }};
}

std::string rocky_grid(const std::string& elsewhere, const std::string& at_sources) {
    std::string text = "ncols 10\nnrows 10\nxllcorner 1000\nyllcorner 2000\ncellsize 5\nNODATA_value -9999\n";
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 10; ++column) {
            const bool source = column == 3 && row > 3 && row < 7;
            text += (source ? at_sources : elsewhere) + (column == 9 ? "\n" : " ");
        }
    }
    return text;
}

const std::vector<std::pair<std::string, std::string>>& rocky_files() {
    static const std::vector<std::pair<std::string, std::string>> files{
        {"dem.asc", rocky_grid("500", "520")},   {"rockdensity.asc", rocky_grid("0", "2650")},
        {"d1.asc", rocky_grid("0", "0.8")},      {"d2.asc", rocky_grid("0", "0.6")},
        {"d3.asc", rocky_grid("0", "0.5")},      {"blshape.asc", rocky_grid("0", "1")},
        {"soiltype.asc", rocky_grid("4", "6")},  {"rg70.asc", rocky_grid("0.25", "0")},
        {"rg20.asc", rocky_grid("0.5", "0.05")}, {"rg10.asc", rocky_grid("0.9", "0.1")},
        {"nrtrees.asc", rocky_grid("400", "0")}, {"dbhmean.asc", rocky_grid("30", "30")},
        {"dbhstd.asc", rocky_grid("8", "8")},    {"conif_percent.asc", rocky_grid("60", "60")},
        {"dem.prj", "PROJCS[\"Some\"]\n"},
    };
    return files;
}

/// `trees`: with a tree file, which goes before the rasters of a forest.
Subject rocky_folder(bool trees) {
    std::vector<std::string> names;
    for (const auto& [name, text] : rocky_files()) {
        names.push_back("rocky/" + name);
    }
    if (trees) {
        names = {"rocky/treefile.txt"};
    }
    return {trees ? "rockyfor3d_trees" : "rockyfor3d", names,
            [trees] {
                auto project = std::make_unique<SampleProject>();
                std::filesystem::create_directory(project->file("rocky"));
                for (const auto& [name, text] : rocky_files()) {
                    project->write("rocky/" + name, text);
                }
                if (trees) {
                    project->write("rocky/treefile.txt", "x y dbh\n1012\t2013\t32.5\n1030\t2040\t18\n");
                }
                return project;
            },
            [](const SampleProject& project) { coupling::rockyfor3d::project_of(project.file("rocky")); }};
}

/// Bare floats, the lowest byte first, of the western half of the sample project.
std::string floats_of_the_west() {
    std::string bytes;
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 6; ++column) {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(400 - 7 * column));
            for (unsigned shift = 0; shift < 32; shift += 8) {
                bytes += static_cast<char>(bits >> shift & 0xFFU);
            }
        }
    }
    return bytes;
}

/// The eastern half as points in rows and columns.
std::string points_of_the_east() {
    std::string text = "x y z\n";
    for (int row = 0; row < 10; ++row) {
        for (int column = 6; column < 12; ++column) {
            text += std::to_string(1005 + 10 * column) + ' ' + std::to_string(2095 - 10 * row) + ' ' +
                    std::to_string(400 - 7 * column) + '\n';
        }
    }
    return text;
}

constexpr const char* virtual_raster =
    "<VRTDataset rasterXSize=\"12\" rasterYSize=\"10\">\n<GeoTransform> 1000, 10, 0, 2100, 0, -10 "
    "</GeoTransform>\n<VRTRasterBand dataType=\"Float32\" band=\"1\">\n<NoDataValue>-9999</NoDataValue>\n"
    "<ComplexSource>\n<SourceFilename relativeToVRT=\"1\">tiles/west.flt</SourceFilename>\n<SrcRect "
    "xOff=\"0\" yOff=\"0\" xSize=\"6\" ySize=\"10\" />\n<DstRect xOff=\"0\" yOff=\"0\" xSize=\"6\" "
    "ySize=\"10\" />\n<NODATA>-1</NODATA>\n</ComplexSource>\n<SimpleSource>\n<SourceFilename "
    "relativeToVRT=\"1\">tiles/east.xyz</SourceFilename>\n<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"6\" "
    "ySize=\"10\" />\n<DstRect xOff=\"6\" yOff=\"0\" xSize=\"6\" ySize=\"10\" />\n</SimpleSource>\n"
    "</VRTRasterBand>\n</VRTDataset>\n";

/// The sample project with its heights in two tiles, which `dem` names.
Subject heights_in_tiles(const std::string& name, const std::string& dem, std::vector<std::string> files) {
    return {name, std::move(files),
            [] {
                auto project = std::make_unique<SampleProject>();
                std::filesystem::create_directory(project->file("tiles"));
                project->write("tiles/west.flt", floats_of_the_west());
                project->write("tiles/west.hdr",
                               "ncols 6\nnrows 10\nxllcorner 1000\nyllcorner 2000\ncellsize 10\nNODATA_value "
                               "-9999\nbyteorder LSBFIRST\n");
                project->write("tiles/east.xyz", points_of_the_east());
                project->write("all.vrt", virtual_raster);
                project->write("list.txt", "# two tiles\ntiles/west.flt\ntiles/east.xyz\n");
                return project;
            },
            [dem](const SampleProject& project) {
                config::Warnings warnings;
                const auto scenario =
                    coupling::read_scenario(project.file("scenario.ini"), {"terrain.dem=" + dem});
                (void)coupling::open_site(*scenario, warnings);
            }};
}

/// Trees in units of their own, on a terrain of points in quotes with names of their own.
Subject trees_in_other_units() {
    return {"units",
            {"trees.csv", "points.csv"},
            [] {
                auto project = std::make_unique<SampleProject>();
                std::string points = "\"rebar_id\",\"x\",\"y\",\"elev\"\n";
                for (int x = 1000; x <= 1120; x += 20) {
                    for (int y = 2000; y <= 2100; y += 20) {
                        const std::string place = std::to_string(x) + "," + std::to_string(y);
                        points += "\"" + place + "\"," + place + ",\"" + std::to_string(1400 - x) + "\"\n";
                    }
                }
                project->write("points.csv", points);
                project->write("trees.csv",
                               "\"tag\",\"spcode\",\"DBH_mm\",\"ht [ft]\",\"UTM.X\",\"UTM.Y\"\n"
                               "1,piab,300,70,1050,2040\n2,fasy,NA,66,1060,2050\n3,piab,412.5,,1070,2060\n");
                project->write("scenario.ini",
                               "[terrain]\npoints = points.csv\nlongest_edge_m = 30\nground = "
                               "fine_debris_and_soil\n[trees]\nfile = trees.csv\n[release]\n"
                               "steeper_than_deg = 30\nrocks_per_source = 1\ndiameter_kind = classes\n"
                               "diameter_classes_m = 0.5\ndiameter_shares = 1\n");
                return project;
            },
            [](const SampleProject& project) {
                config::Warnings warnings;
                const auto scenario = coupling::read_scenario(project.file("scenario.ini"), {});
                (void)coupling::open_site(*scenario, warnings);
            }};
}

Subject validation_case(const coupling::validation::CaseFiles& files) {
    Subject subject;
    subject.name = "validation/" + files.name;
    for (const auto& [file, text] : files.texts) {
        if (file != "README.md") {
            subject.files.push_back("case/" + file);
        }
    }
    subject.make = [texts = files.texts] {
        auto project = std::make_unique<SampleProject>();
        std::filesystem::create_directory(project->file("case"));
        for (const auto& [file, text] : texts) {
            project->write("case/" + file, text);
        }
        return project;
    };
    subject.read = [](const SampleProject& project) {
        for (const auto& one : coupling::validation::cases_in(project.file("case"))) {
            const auto read = coupling::validation::read_case(one);
            if (!read.comparison) {
                (void)read.profile(*read.recipe("default"));
            }
        }
    };
    return subject;
}

}  // namespace

std::vector<Subject> subjects_of_cases() {
    std::vector<Subject> subjects;
    for (const coupling::validation::CaseFiles& shipped : coupling::validation::shipped_cases()) {
        // Reading `collapse` cuts a cliff into 844 blocks; subjects_of_collapse() feeds its readers with few.
        if (shipped.name != "collapse") {
            subjects.push_back(validation_case(shipped));
        }
        // Each reading of `g318` opens 44 scenarios; other cases have the same files but this one.
        if (shipped.name == "g318") {
            subjects.back().files = {"case/trends.csv"};
        }
        // The same of `forest_yield` with its 29 sites.
        if (shipped.name == "forest_yield") {
            subjects.back().files = {"case/yield_tables.csv", "case/figures.sql"};
        }
        // Of `forest_regeneration` with its 11, each of 9 ha.
        if (shipped.name == "forest_regeneration") {
            subjects.back().files = {"case/sites.csv", "case/gap.csv", "case/selection.csv"};
        }
        // And of `forest_demography` with its many.
        if (shipped.name == "forest_demography") {
            subjects.back().files = {"case/sites.csv", "case/size_classes.csv"};
        }
    }
    return subjects;
}

std::vector<Subject> subjects_of_files() {
    std::vector<Subject> subjects = files_of_info();
    subjects.push_back(table_alone("recipe.csv", std::string{config::shipped_table("stopping_recipe.csv")},
                                   [](const config::Table& table) { coupling::read_recipe(table); }));
    subjects.push_back(table_alone(
        "lines.csv",
        "name,height_m,capacity_kj,class,gap_m,wkt\nupper,1.2,5,,0.1,\"LINESTRING (1075 2010, 1078 2050)\"\n"
        "lower,3,,1,,\"LINESTRING (1098 2005, 1098 2095)\"\n",
        [](const config::Table& table) {
            const auto nets = coupling::nets_of(table, coupling::Standing::each_alone).nets;
            (void)coupling::net_warnings(table, nets);
        }));
    subjects.push_back(table_alone("felled.csv", "tree_id,year\n12,2003\n7,1998\n",
                                   [](const config::Table& table) { coupling::read_fell_list(table); }));
    subjects.push_back(table_alone("stems.csv", "stand,age_years,stems_pha\n1,30,3000\n1,40,2000\n",
                                   [](const config::Table& table) { coupling::read_stem_numbers(table); }));
    subjects.push_back(
        heights_in_tiles("tiles_of_folder", "tiles", {"tiles/west.flt", "tiles/west.hdr", "tiles/east.xyz"}));
    subjects.push_back(heights_in_tiles("tiles_of_list", "list.txt", {"list.txt"}));
    subjects.push_back(heights_in_tiles("tiles_of_vrt", "all.vrt", {"all.vrt"}));
    subjects.push_back(trees_in_other_units());
    subjects.push_back(rocky_folder(false));
    subjects.push_back(rocky_folder(true));
    return subjects;
}

}  // namespace fuzz
