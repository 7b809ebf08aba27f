#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling::bad_input_test {
namespace {

/// What is wrong with the project and what the program has to say about it.
struct BadInput {
    std::string name;
    void (*spoil)(SampleProject&);
    int code;
    std::string message;         ///< part of what goes to stderr
    std::string arguments = "";  ///< after `run scenario.ini`
};

void PrintTo(const BadInput& bad, std::ostream* out) {
    *out << bad.name;
}

const BadInput bad_inputs[] = {
    {"MissingScenario", [](SampleProject& p) { p.remove("scenario.ini"); }, 3,
     "bannwald: scenario.ini: found no file 'scenario.ini', expected a scenario file"},
    {"MissingDem", [](SampleProject& p) { p.remove("dem.asc"); }, 3,
     "bannwald: scenario.ini:2:7: found no file 'dem.asc', expected a grid (GeoTIFF or ESRI ASCII)"},
    {"MissingTrees", [](SampleProject& p) { p.remove("trees.csv"); }, 3,
     "bannwald: scenario.ini:6:8: found no file 'trees.csv', expected a table or layer"},
    {"UnknownKey", [](SampleProject& p) { p.replace("scenario.ini", "diameter_m", "diametre_m"); }, 2,
     "release.diameter_m"},
    {"UnknownKeyOnTheCommandLine", [](SampleProject&) {}, 2, "release.rocks", "--set release.roks=3"},
    {"WrongType",
     [](SampleProject& p) { p.replace("scenario.ini", "diameter_m = 0.5", "diameter_m = large"); }, 2,
     "bannwald: scenario.ini:10:"},
    {"DecimalComma",
     [](SampleProject& p) { p.replace("scenario.ini", "diameter_m = 0.5", "diameter_m = 0,5"); }, 2,
     "bannwald: scenario.ini:10:"},
    {"SurfaceOfAnotherExtent",
     [](SampleProject& p) { p.replace("surface.asc", "corner 1000", "corner 1020"); }, 4,
     "bannwald: surface.asc: found 12 x 10 cells of 10 m, corner 1020, 2000, expected the frame of dem.asc"},
    {"SurfaceOfAnotherCellSize", [](SampleProject& p) { p.replace("surface.asc", "size 10", "size 20"); }, 4,
     "bannwald: surface.asc: found 12 x 10 cells of 20 m"},
    {"SourceOfAnotherExtent", [](SampleProject& p) { p.replace("source.asc", "corner 1000", "corner 1020"); },
     4,
     "bannwald: source.asc: found 12 x 10 cells of 10 m, corner 1020, 2000, expected the frame of dem.asc"},
    {"NodataInTheReleaseArea",
     [](SampleProject& p) {
         p.write("dem.asc", SampleProject::header() + SampleProject::rows([](int column, int row) {
                                return column == 2 && row == 4 ? "-9999" : std::to_string(400 - 7 * column);
                            }));
     },
     4, "bannwald: source.asc: found 1 source cell on NODATA of dem.asc"},
    {"SourcesInTheOuterRingOnly",
     [](SampleProject& p) {
         p.write("source.asc", SampleProject::header() + SampleProject::rows([](int column, int) {
                                   return column == 0 ? "1" : "0";
                               }));
     },
     4, "bannwald: source.asc: found no source of rocks that lies on the terrain"},
    {"EmptyRelease",
     [](SampleProject& p) {
         p.write("source.asc", SampleProject::header() + SampleProject::rows([](int, int) { return "0"; }));
     },
     4, "bannwald: source.asc: found no source of rocks that lies on the terrain"},
    {"TreeOutsideWithStrictInputs",
     [](SampleProject& p) { p.replace("trees.csv", "1060,2050", "1060,2500"); }, 4,
     "bannwald: trees.csv: found 1 of 3 trees off the terrain, such as tree '1'",
     "--set run.strict_inputs=yes"},
    {"UnknownSpecies", [](SampleProject& p) { p.replace("trees.csv", "piab", "piax"); }, 4,
     "bannwald: trees.csv:3:13: found species 'piax', expected a code or Latin name of the species table "
     "(PIAB?)"},
    {"DiameterOfATreeZero", [](SampleProject& p) { p.replace("trees.csv", "32.5", "0"); }, 4,
     "bannwald: trees.csv:2:18: found dbh_cm '0', expected a number in (0, 500]"},
    {"SurfaceCodeWithoutParameters",
     [](SampleProject& p) { p.replace("surface_types.csv", "3,soil", "4,soil"); }, 4,
     "bannwald: surface.asc: found surface code 3 in 90 cells"},
    {"RocksOfNoSize",
     [](SampleProject& p) { p.replace("scenario.ini", "diameter_m = 0.5", "diameter_m = 0"); }, 2,
     "bannwald: scenario.ini:10:"},
    {"NoRocks", [](SampleProject&) {}, 2, "no rocks", "--set release.rocks_per_source=0"},
    {"GridThatIsNone", [](SampleProject& p) { p.replace("dem.asc", "386", "38b"); }, 4,
     "bannwald: dem.asc:6:"},
};

class Program : public ::testing::TestWithParam<BadInput> {};

TEST_P(Program, TellsWhatIsWrongAndLeavesNothingBehind) {
    SampleProject project;
    GetParam().spoil(project);
    const Outcome outcome = call(project, "run scenario.ini " + GetParam().arguments);
    EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().message), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(project.file("out")));
}

TEST_P(Program, ChecksWithTheSameVerdict) {
    SampleProject project;
    GetParam().spoil(project);
    const Outcome outcome = call(project, "check scenario.ini " + GetParam().arguments);
    EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().message), std::string::npos) << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(BadInput, Program, ::testing::ValuesIn(bad_inputs),
                         [](const ::testing::TestParamInfo<BadInput>& bad) { return bad.param.name; });

TEST(ProgramWithDoubts, GoesOnAndTellsThem) {
    SampleProject project;
    project.replace("trees.csv", "1060,2050", "1060,2500");
    project.replace("trees.csv", "piab", "taba");
    const Outcome outcome = call(project, "run scenario.ini --quiet");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Outcome checked = call(project, "check scenario.ini");
    EXPECT_NE(checked.err.find("warning: trees.csv: found 1 of 3 trees off the terrain"), std::string::npos)
        << checked.err;
    EXPECT_NE(checked.err.find("note: trees.csv: 1 tree of TABA (Taxus baccata) taken like ABAL"),
              std::string::npos)
        << checked.err;
}

TEST(ProgramOverResults, RefusesUnlessToldToOverwrite) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet").code, 0);
    const Outcome again = call(project, "run scenario.ini --quiet");
    EXPECT_EQ(again.code, 2) << again.err;
    EXPECT_NE(again.err.find("--overwrite"), std::string::npos) << again.err;
    EXPECT_EQ(call(project, "run scenario.ini --quiet --overwrite").code, 0);
}

}  // namespace
}  // namespace coupling::bad_input_test
