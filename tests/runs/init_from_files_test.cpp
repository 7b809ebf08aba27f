// From files of the user to a project that runs: `bannwald init DIR --dem ...`.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "config/grid/ascii_grid.hpp"
#include "tests/coupling/inputs/formats/given_files.hpp"
#include "tests/coupling/inputs/grids/tile_files.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/program.hpp"

namespace coupling::init_from_files_test {
namespace {

constexpr const char* all_files =
    " --dem dem.tif --sources 'layers.gpkg|cliff' --targets targets.geojson --trees trees.shp --grounds "
    "'layers.gpkg|grounds'";

/// The scenario with the lines of a section as if they were not commented out.
std::string with_section(const std::string& scenario, const std::string& section) {
    const std::size_t begin = scenario.find("\n[" + section + "]\n");
    EXPECT_NE(begin, std::string::npos) << section;
    const std::size_t end = std::min(scenario.find("\n[", begin + 1), scenario.size());
    std::string lines = scenario.substr(begin, end - begin);
    EXPECT_NE(lines.find("\n;"), std::string::npos) << section;
    for (std::size_t at = lines.find("\n;"); at != std::string::npos; at = lines.find("\n;", at)) {
        lines.erase(at + 1, 1);
    }
    return scenario.substr(0, begin) + lines + scenario.substr(end);
}

TEST(InitFromFiles, OffersSectionsThatCanBeTaken) {
    const SampleProject project;
    take_given_files(project);
    ASSERT_EQ(call(project, std::string{"init own"} + all_files).code, 0);
    const std::string scenario = project.read("own/scenario.ini");
    project.write("own/return_periods.csv", "return_period_years,zone,diameter_m\n30,,0.5\n100,,1\n");
    project.write(
        "own/logo.png",
        std::string{"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55\0\0"
                    "\0\nIDAT\x78\x9c\x63\x60\0\0\0\2\0\1\x48\xaf\xa4\x71\0\0\0\0IEND\xae\x42\x60\x82",
                    67});
    for (const std::string section : {"nets", "design", "hazard", "report", "output"}) {
        std::string taken = with_section(scenario, section);
        if (section == "design") {
            // As it stands it adds nothing, which is refused until a factor of a guideline stands there.
            project.write("own/scenario.ini", taken);
            EXPECT_NE(call(project, "check own/scenario.ini").err.find("design.rule own that adds nothing"),
                      std::string::npos);
            taken.replace(taken.find("energy_factor = 1.0"), 19, "energy_factor = 1.2");
        }
        project.write("own/scenario.ini", taken);
        const Outcome check = call(project, "check own/scenario.ini");
        EXPECT_EQ(check.code, 0) << section << check.err;
        // With blocks by return period the guessed sizes of the rocks say nothing any more.
        EXPECT_EQ(check.err.find("no effect") != std::string::npos, section == "hazard")
            << section << check.err;
    }
}

TEST(InitFromFiles, MakesAProjectThatRuns) {
    const SampleProject project;
    take_given_files(project);
    const Outcome made = call(project, std::string{"init own"} + all_files);
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.out, "own/scenario.ini\n");
    for (const std::string sentence :
         {"- dem.tif: ground heights, 12 x 10 cells of 10 m, corner 1000, 2000, 'JGD_2000_Japan_Zone_1'\n",
          "- layers.gpkg|grounds: ground types, codes 1, 3; what they mean is a guess in surface_types.csv\n",
          "- trees.shp: 3 trees\n", "- layers.gpkg|cliff: 1 shape as sources\n",
          "targets.geojson: column 'id' is taken as target_id\n", "- targets.geojson: 2 targets\n",
          "next: bannwald run own/scenario.ini\n"}) {
        EXPECT_NE(made.err.find(sentence), std::string::npos) << sentence << made.err;
    }
    const std::string scenario = project.read("own/scenario.ini");
    EXPECT_NE(scenario.find("dem = ../dem.tif "), std::string::npos) << scenario;
    EXPECT_NE(scenario.find("source_shapes = ../layers.gpkg|cliff "), std::string::npos) << scenario;
    const Outcome run = call(project, "run own/scenario.ini --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(std::filesystem::exists(project.file("own/out/report.html")));
}

TEST(InitFromFiles, NeedsTheHeightsOnlyAndGuessesTheSources) {
    const SampleProject project;
    project.write("dem.asc",
                  SampleProject::header() + SampleProject::rows([](int column, int row) {
                      return std::to_string(400 - (column > 4 && column < 7 && row > 2 ? 20 : 7) * column);
                  }));
    const Outcome made = call(project, "init own --dem dem.asc");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("steeper than 46.3 degrees (source.asc) are a guess"), std::string::npos)
        << made.err;
    EXPECT_NE(made.err.find("no trees given: the bare slope alone"), std::string::npos) << made.err;
    EXPECT_NE(project.read("own/scenario.ini").find("GUESS: one ground everywhere"), std::string::npos);
    EXPECT_EQ(call(project, "run own/scenario.ini --quiet").code, 0);
}

TEST(InitFromFiles, MarksItsGuessesUntilTheyAreChecked) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init own --dem dem.asc --sources source.asc").code, 0);
    const std::string warning =
        "scenario.ini: found settings that are marked GUESS: terrain.ground, release.density_kgpm3, "
        "release.diameter_kind, release.diameter_classes_m, release.diameter_shares, expected values of this "
        "slope; check them, then take the word out of their lines\n";
    const Outcome guessed = call(project, "run own/scenario.ini --quiet");
    ASSERT_EQ(guessed.code, 0) << guessed.err;
    EXPECT_NE(guessed.err.find(warning), std::string::npos) << guessed.err;
    // Where a table says which rocks there are, guessed diameters decide nothing.
    project.write("own/blocks.csv", "return_period_years,zone,diameter_m\n30,,0.5\n100,,1\n");
    const Outcome by_period = call(project, "check own/scenario.ini --set hazard.blocks=blocks.csv");
    EXPECT_NE(by_period.err.find("marked GUESS: terrain.ground, release.density_kgpm3, expected"),
              std::string::npos)
        << by_period.err;
    const std::string page = project.read("own/out/report.html");
    EXPECT_NE(page.find("2\u202f700 kg/m³ <span class=\"mark given\">guess</span>"), std::string::npos);

    std::string checked = project.read("own/scenario.ini");
    for (std::size_t at = checked.find("; GUESS"); at != std::string::npos; at = checked.find("; GUESS")) {
        checked.replace(at, 7, "; seen");
    }
    project.write("own/scenario.ini", checked);
    const Outcome seen = call(project, "run own/scenario.ini --quiet --overwrite");
    ASSERT_EQ(seen.code, 0) << seen.err;
    EXPECT_EQ(seen.err.find("GUESS"), std::string::npos) << seen.err;
    EXPECT_EQ(project.read("own/out/report.html").find(">guess<"), std::string::npos);
}

TEST(InitFromFiles, TakesListsAsSpreadsheetsWriteThem) {
    const SampleProject project;
    project.write("list.csv",
                  "Nr;Ost;Nord;Baumart;BHD;H\xF6he\r\n1;1060;2050;Wei\xDF"
                  "tanne;32,5;25\r\n");
    const Outcome made = call(project, "init own --dem dem.asc --sources source.asc --trees list.csv");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("'BHD' = dbh_cm"), std::string::npos) << made.err;
}

TEST(InitFromFiles, TakesACanopyRasterForTrees) {
    const SampleProject project;
    std::string text = "ncols 30\nnrows 30\nxllcorner 1050\nyllcorner 2030\ncellsize 1\n";
    for (int row = 0; row < 30; ++row) {
        for (int column = 0; column < 30; ++column) {
            const int steps = std::max(std::abs(row % 10 - 5), std::abs(column % 10 - 5));
            text += std::to_string(steps < 3 ? 20.5 + column / 10 - 3.0 * steps : 0.0) + " ";
        }
        text += "\n";
    }
    project.write("chm.asc", text);
    const Outcome made = call(project, "init own --dem dem.asc --sources source.asc --trees chm.asc");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("9 tree tops"), std::string::npos) << made.err;
    const std::string scenario = project.read("own/scenario.ini");
    EXPECT_NE(scenario.find("canopy = ../chm.asc"), std::string::npos) << scenario;
    EXPECT_NE(scenario.find("species = PIAB    ; GUESS"), std::string::npos) << scenario;
    const Outcome check = call(project, "check own/scenario.ini");
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_NE(check.err.find("found 9 tree tops of 5 m and more"), std::string::npos) << check.err;
    const Outcome terrain = call(project, "init other --dem dem.asc --sources source.asc --trees dem.asc");
    EXPECT_EQ(terrain.code, 4);
    EXPECT_NE(terrain.err.find("cells of 10 m"), std::string::npos) << terrain.err;
}

/// What it writes, the program accepts: each role in each format, beside each format of the terrain.
class AnyFormats : public ::testing::TestWithParam<unsigned> {};

TEST_P(AnyFormats, BecomeAProjectThatIsCheckedAndRuns) {
    const SampleProject project;
    take_given_files(project);
    project.write("cliff.csv", "wkt\n\"LINESTRING (1025 2035, 1025 2065)\"\n");
    project.write("ground_polygons.csv",
                  "code,wkt\n1,\"POLYGON ((1000 2000, 1030 2000, 1030 2100, 1000 2100, 1000 2000))\"\n");
    // Every format of a role stands beside every format of the others in some of the calls: the steps have no
    // common divisor with the numbers of formats.
    unsigned number = GetParam();
    std::string arguments;
    const auto add = [&](const char* option, std::initializer_list<const char*> files, unsigned step) {
        const std::string file = *(files.begin() + (number / step) % files.size());
        arguments += file.empty() ? "" : std::string{" "} + option + " '" + file + "'";
    };
    add("--dem", {"dem.tif", "dem.asc"}, 1);
    add("--sources", {"layers.gpkg|cliff", "source.tif", "source.asc", "cliff.csv"}, 1);
    add("--targets", {"targets.geojson", "targets.csv", "road.shp", ""}, 3);
    add("--trees", {"trees.shp", "trees.csv", ""}, 5);
    add("--grounds", {"layers.gpkg|grounds", "surface.asc", "ground_polygons.csv", ""}, 7);
    const Outcome made = call(project, "init own" + arguments);
    ASSERT_EQ(made.code, 0) << arguments << '\n' << made.err;
    const Outcome check = call(project, "check own/scenario.ini");
    EXPECT_EQ(check.code, 0) << arguments << '\n' << check.err;
    const Outcome run = call(project, "run own/scenario.ini --quiet --set release.rocks=20");
    EXPECT_EQ(run.code, 0) << arguments << '\n' << run.err;
}

INSTANTIATE_TEST_SUITE_P(InitFromFiles, AnyFormats, ::testing::Range(0U, 24U));

TEST(InitFromFiles, TakesTilesAndSeveralFilesForOneThing) {
    const SampleProject project;
    const config::Raster<double> heights = config::read_ascii_grid(project.read("dem.asc"), "dem.asc");
    std::filesystem::create_directory(project.file("tiles"));
    for (const grids::CellWindow& window : four_windows(heights.frame, {7, 4}, 1)) {
        write_tile(project, "tiles/" + std::to_string(heights.frame.index(window.first)), ".flt",
                   cut_out(heights, window));
    }
    add_nets(project);
    project.write("road.csv", "target_id,wkt\n,\"LINESTRING (1105 2010, 1105 2090)\"\n");
    project.write("houses.csv",
                  "target_id,wkt\n,\"POLYGON ((1090 2040, 1100 2040, 1100 2050, 1090 2050, 1090 2040))\"\n");
    project.write("areas.csv",
                  "code,wkt\nFels,\"POLYGON ((1000 2000, 1060 2000, 1060 2100, 1000 2100, 1000 2000))\"\n"
                  "Ödland,\"POLYGON ((1060 2000, 1120 2000, 1120 2100, 1060 2100, 1060 2000))\"\n");
    project.write(
        "more_areas.csv",
        "code,wkt\nMähwiese,\"POLYGON ((1090 2000, 1120 2000, 1120 2100, 1090 2100, 1090 2000))\"\n");
    const Outcome made =
        call(project,
             "init own --dem tiles --sources source.asc --targets road.csv --targets houses.csv "
             "--grounds areas.csv --grounds more_areas.csv --nets nets.csv");
    ASSERT_EQ(made.code, 0) << made.err;
    for (const std::string sentence :
         {"- tiles: ground heights, tiles of together 12 x 10 cells of 10 m, corner 1000, 2000, 'Sample'\n",
          "- areas.csv, more_areas.csv: ground types, 'Fels' like solid_rock, 'Ödland' like "
          "fine_debris_and_soil (no word known), 'Mähwiese' like pasture; what they mean is a guess in "
          "surface_types.csv\n",
          "- road.csv, houses.csv: 2 targets\n", "- nets.csv: rockfall nets\n"}) {
        EXPECT_NE(made.err.find(sentence), std::string::npos) << sentence << made.err;
    }
    EXPECT_NE(project.read("own/scenario.ini").find("file = ../road.csv, ../houses.csv  "),
              std::string::npos);
    const Outcome run = call(project, "run own/scenario.ini --quiet --set release.rocks=200");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(project.read("own/out/tables/targets.csv").find("houses_1,"), std::string::npos);
    // The archive holds every tile: the run of what it holds has the same bytes.
    const Outcome packed_run = call(project, "pack own/out -q");
    ASSERT_EQ(packed_run.code, 0) << packed_run.err;
    const Outcome verified = call(project, "verify own/out.zip --rerun");
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
}

/// Works go in as nets do: the run finds them where they lie, and without them the section is offered.
TEST(InitFromFiles, TakesWorks) {
    const SampleProject project;
    project.write("dams.csv",
                  "name,kind,height_m,width_m,uphill_face_deg,downhill_face_deg,wkt\n"
                  "dam,dam,4,2,60,56,\"LINESTRING (1075 2025, 1075 2075)\"\n");
    project.write(
        "walls.csv",
        "name,kind,height_m,capacity_kj,wkt\nwall,wall,1.5,20,\"LINESTRING (1098 2010, 1098 2090)\"\n");
    const Outcome made =
        call(project, "init own --dem dem.asc --sources source.asc --works dams.csv --works walls.csv");
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("- dams.csv, walls.csv: dams, ditches, walls or galleries\n"), std::string::npos)
        << made.err;
    const Outcome run = call(project, "run own/scenario.ini --quiet --set release.rocks=200");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string works = project.read("own/out/tables/works.csv");
    EXPECT_NE(works.find("\ndam,"), std::string::npos) << works;
    EXPECT_NE(works.find("\nwall,"), std::string::npos) << works;
    ASSERT_EQ(call(project, "init other --dem dem.asc --sources source.asc").code, 0);
    const std::string offered = project.read("other/scenario.ini");
    EXPECT_NE(offered.find("[works]\n;file = works.csv"), std::string::npos);
    EXPECT_EQ(project.read("own/scenario.ini").find(";file = works.csv"), std::string::npos);
    EXPECT_EQ(call(project, "init third --works dams.csv").code, 2);
}

TEST(InitFromFiles, LeavesAFolderWithFilesAlone) {
    const SampleProject project;
    std::filesystem::create_directory(project.file("own"));
    project.write("own/notes.txt", "mine");
    const Outcome outcome = call(project, "init own --dem dem.asc --sources source.asc");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("found files in folder 'own', expected a new or empty folder"),
              std::string::npos);
    EXPECT_EQ(project.read("own/notes.txt"), "mine");
}

}  // namespace
}  // namespace coupling::init_from_files_test
