// What practitioners get wrong on their first day: the program refuses it with the likely cause and what to
// do, or says it on the first screen of the page.

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <sstream>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::mistaken_input_test {
namespace {

/// A mistake in the example project of the Tyrol and what the program has to say about it.
struct Mistake {
    std::string name;
    std::string spoil;  ///< a shell script in the folder of the project
    int code = 4;
    std::string found;  ///< parts of what goes to stderr
    std::string advice;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

/// Exchanges or changes columns of trees.csv: tree_id,x_m,y_m,species,dbh_cm,height_m.
std::string trees_by(const std::string& awk) {
    return "awk -F, -v OFS=, 'NR == 1 {print; next} {" + awk + "; print}' trees.csv > t && mv t trees.csv\n";
}

constexpr const char* utm =
    "echo 'PROJCS[\"WGS_1984_UTM_Zone_32N\",GEOGCS[\"GCS_WGS_1984\"],PROJECTION[\"Transverse_Mercator\"],"
    "PARAMETER[\"False_Easting\",500000.0],PARAMETER[\"False_Northing\",0.0],PARAMETER[\"Central_Meridian\","
    "9.0],"
    "UNIT[\"Meter\",1.0]]' > dem.prj\n";

constexpr const char* logs_swapped =
    "printf 'x1_m,y1_m,x2_m,y2_m,species,dbh_cm\\n377500,177700,377505,177704,PIAB,40\\n' > logs.csv\n"
    "sed -i 's/^file = trees.csv/&\\nlogs = logs.csv/' scenario.ini\n";

constexpr const char* sources_in_degrees =
    "printf 'wkt\\nPOINT (10.4 47.3)\\nPOINT (10.401 47.301)\\n' > s.csv\n"
    "sed -i 's/^source = .*/source_shapes = s.csv/' scenario.ini\n";

constexpr const char* zone_outside =
    "printf 'zone;wkt\\n1;POLYGON ((177500 377500, 177700 377500, 177700 377600, 177500 377600, 177500 "
    "377500))\\n"
    "2;POLYGON ((179600 377500, 179700 377500, 179700 377600, 179600 377600, 179600 377500))\\n' > s.csv\n"
    "sed -i 's/^source = .*/source_shapes = s.csv/' scenario.ini\n";

constexpr const char* road_swapped =
    "printf 'target_id;wkt\\nroad;LINESTRING (377400 177600, 377450 177900)\\n' > targets.csv\n";

const Mistake mistakes[] = {
    {"TreesWithSwappedAxes", trees_by("t = $2; $2 = $3; $3 = t"), 4,
     "trees off the terrain: x and y look swapped",
     "; set trees.swap_xy = yes, or exchange the columns x_m and y_m"},
    {"TreesInDegrees", trees_by("$2 = 10.4; $3 = 47.3"), 4,
     "they look like degrees of longitude and latitude",
     "; transform the file to the coordinate system of the terrain"},
    {"TreesInAnotherSystem", trees_by("$2 += 2500000; $3 += 800000"), 4,
     "they would fit CH1903+ / LV95 (EPSG 2056), the terrain MGI / Austria Lambert", "; transform the file"},
    {"LogsWithSwappedAxes", logs_swapped, 4,
     "logs.csv: found 1 of 1 log off the terrain: x and y look swapped", "; set trees.swap_logs_xy = yes"},
    {"SourcesInDegrees", sources_in_degrees, 4,
     "100 % of the sources off the terrain: they look like degrees", "; transform the file"},
    {"AZoneOutside", zone_outside, 4, "s.csv:3:3: found 100 % of the area of zone 2 off the terrain",
     "; compare the coordinate system"},
    {"ATargetWithSwappedAxes", road_swapped, 4, "target 'road' outside the terrain: x and y look swapped",
     "; exchange x and y in the shapes"},
    {"DiametersInMetres", trees_by("$5 /= 100"), 4, "which looks like metres, expected centimetres",
     "; multiply the column dbh_cm by 100"},
    {"DiametersInMillimetres", trees_by("$5 *= 10"), 4, "which looks like millimetres, expected centimetres",
     "; multiply the column dbh_cm by 0.1"},
    {"HeightsInDecimetres", trees_by("$6 *= 10"), 4,
     "which looks like decimetres or centimetres, expected metres", "; write the heights in metres"},
    {"HeightsOfTheTerrainInCentimetres",
     "awk 'NR <= 6 {print; next} {for (i = 1; i <= NF; ++i) if ($i > 0) $i *= 100; print}' dem.asc > d && mv "
     "d dem.asc\n",
     4, "expected metres above sea level, -500 to 9000", "; write the heights in metres"},
    {"RocksWithAPointForThousands", "sed -i 's/^rocks_per_source.*/rocks = 2.000/' scenario.ini\n", 2,
     "release.rocks = '2.000', expected a whole number", "; write 2000 without separators of thousands"},
    {"RocksWithAnApostropheForThousands", "sed -i \"s/^rocks_per_source.*/rocks = 2'000/\" scenario.ini\n", 2,
     "release.rocks = '2'000', expected a whole number", "; write 2000 without separators of thousands"},
    {"RocksWithABlankForThousands", "sed -i 's/^rocks_per_source.*/rocks = 2 000/' scenario.ini\n", 2,
     "release.rocks = '2 000', expected a whole number", "; write 2000 without separators of thousands"},
    {"HeightsWithTheWrongSign",
     "awk 'NR <= 6 {print; next} {for (i = 1; i <= NF; ++i) if ($i > 0) $i = -$i; print}' dem.asc > d && mv "
     "d dem.asc\n",
     4, "expected metres above sea level, -500 to 9000", "; change the sign of the heights"},
    {"RestitutionsInPercent", "sed -i 's/,0.40,0.90,/,40,90,/' surface_types.csv\n", 4,
     "found r_n '40', expected a number in [0, 0.99]", "; write a share of 1: divide percents by 100"},
    {"GirthsInTheirOwnColumn", "sed -i '1s/dbh_cm/Umfang (cm)/' trees.csv\n", 4,
     "no column 'dbh_cm', but girths in the column 'Umfang (cm)'", "; add a column dbh_cm"},
    {"ATargetThatIsAPoint", "printf 'target_id;wkt\\nhouse;POINT (177711 377859)\\n' > targets.csv\n", 4,
     "expected lines or polygons", "; make areas of the points"},
    {"ATargetWithoutShape", "printf 'target_id;wkt\\nhouse;LINESTRING EMPTY\\n' > targets.csv\n", 4,
     "found an empty shape", "; draw the shape, or delete the row"},
    {"TheProjectionFileOfAnotherMap", utm, 4,
     "dem.prj: found coordinates of 177 198 to 178 298 east, 376 898 to 378 102 north with the projection "
     "'WGS_1984_UTM_Zone_32N', expected for UTM zone 32N about",
     "; replace dem.prj: the coordinates would fit MGI / Austria Lambert (EPSG 31287)"},
};

class MistakenInput : public ::testing::TestWithParam<Mistake> {};

TEST_P(MistakenInput, IsRefusedWithItsCauseAndWhatToDo) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init p --quiet").code, 0);
    ASSERT_EQ(shell(project, "cd p\n" + GetParam().spoil).code, 0);
    const Outcome outcome = call(project, "run p/scenario.ini --quiet");
    EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().found), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().advice), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("p/out")));
}

INSTANTIATE_TEST_SUITE_P(Practitioners, MistakenInput, ::testing::ValuesIn(mistakes),
                         [](const auto& mistake) { return mistake.param.name; });

/// What stands on a page above its heading.
std::string first_screen(const SampleProject& project, const std::string& page) {
    const std::string text = project.read(page);
    return text.substr(0, text.find("<h2>"));
}

TEST(MistakenInputPartly, StandsOnTheFirstScreenAndInTheClosingLinesOfAQuietRun) {
    const SampleProject project;
    project.write("areas.csv",
                  "zone,wkt\n1,\"POLYGON ((995 2030, 1015 2030, 1015 2070, 995 2070, 995 2030))\"\n"
                  "1,\"POLYGON ((1020 2030, 1030 2030, 1030 2070, 1020 2070, 1020 2030))\"\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = areas.csv");
    project.replace("trees.csv", "1060,2050", "1060,2500");
    const Outcome outcome = call(project, "run scenario.ini --quiet");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const std::string screen = first_screen(project, "out/report.html");
    for (const std::string part :
         {"with 50 % of its area (400 m2 of 800 m2) off the terrain; no rock starts there",
          "1 of 3 trees off the terrain",
          "only 20 rocks are released in all: a share of 50 % is uncertain by 22"}) {
        EXPECT_NE(outcome.err.find(part), std::string::npos) << part << '\n' << outcome.err;
        EXPECT_NE(screen.find(part), std::string::npos) << part << '\n' << screen;
    }
}

TEST(WarningsOfARun, AreItsClosingLines) {
    const SampleProject project;
    project.replace("trees.csv", "1060,2050", "1060,2500");
    const Outcome both = shell(project, "\"$bannwald\" run scenario.ini --set release.rocks=200 2>&1");
    ASSERT_EQ(both.code, 0) << both.out;
    const std::size_t results = both.out.find("Results in ");
    // Rocks may leave the small slope, too: that warning speaks of the answer and stands before this one.
    const std::size_t closing = both.out.find("bannwald: done, with ");
    ASSERT_NE(results, std::string::npos) << both.out;
    ASSERT_NE(closing, std::string::npos) << both.out;
    EXPECT_LT(results, closing);
    const std::size_t tree = both.out.find("bannwald: warning: trees.csv", closing);
    ASSERT_NE(tree, std::string::npos) << both.out;
    EXPECT_EQ(both.out.find("bannwald: done, with ", closing + 1), std::string::npos) << both.out;
    // Nothing but warnings and the number of notes stands below.
    std::istringstream below{both.out.substr(closing)};
    for (std::string line; std::getline(below, line);) {
        EXPECT_TRUE(line.starts_with("bannwald: ")) << line;
    }
}

TEST(WarningsOfARun, StandOnTheFirstScreenOfEveryKindOfPage) {
    const SampleProject project;
    project.replace("trees.csv", "1060,2050", "1060,2500");
    const std::string tree = "1 of 3 trees off the terrain";
    for (const char* folder : {"a", "b"}) {
        ASSERT_EQ(
            call(project, "run scenario.ini -q --set release.rocks=200 --out " + std::string{folder}).code,
            0);
    }
    ASSERT_EQ(call(project, "compare a b --quiet --page c.html").code, 0);
    EXPECT_NE(first_screen(project, "c.html").find(tree), std::string::npos)
        << first_screen(project, "c.html");

    project.write("blocks.csv", "return_period_years,zone,diameter_m\n10,1,0.3\n30,1,0.5\n");
    project.replace("scenario.ini", "diameter_m = 0.5\n", "");
    project.replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
    const Outcome hazard = call(project, "run scenario.ini -q --set release.rocks=200");
    ASSERT_EQ(hazard.code, 0) << hazard.err;
    EXPECT_NE(hazard.err.find(tree), std::string::npos) << hazard.err;
    for (const char* page : {"out/hazard/report.html", "out/return_period_10/report.html"}) {
        EXPECT_NE(first_screen(project, page).find(tree), std::string::npos) << page;
    }
}

TEST(WarningsOfARun, StandOnTheFirstScreenOverYearsAndAlongAProfile) {
    const ForestProject years;
    const std::string leaving = "of the rocks leave the terrain";
    const Outcome decades = call(years, std::string{four_members});
    ASSERT_EQ(decades.code, 0) << decades.err;
    EXPECT_NE(decades.err.find(leaving), std::string::npos) << decades.err;
    EXPECT_NE(first_screen(years, "out/report.html").find(leaving), std::string::npos);

    const SampleProject project;
    ASSERT_EQ(call(project, "init p --quiet --example profile").code, 0);
    const Outcome profile = call(project, "run p/scenario.ini --quiet --set release.rocks=50");
    ASSERT_EQ(profile.code, 0) << profile.err;
    EXPECT_NE(profile.err.find("only 50 rocks"), std::string::npos) << profile.err;
    EXPECT_NE(first_screen(project, "p/out/report.html").find("only 50 rocks"), std::string::npos);
}

TEST(ThePage, SaysWhyNoTreesAreLeft) {
    const SampleProject project;
    project.write("trees.csv", "tree_id,x_m,y_m,species,dbh_cm,height_m\n");
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set release.rocks=200").code, 0);
    const std::string page = project.read("out/report.html");
    EXPECT_NE(page.find("no trees or logs are left: trees.csv list none on the terrain"), std::string::npos);
    EXPECT_EQ(page.find("were given"), std::string::npos);
}

TEST(TheCounts, OfTablesRefuseSeparatorsOfThousands) {
    const SampleProject project;
    project.write("points.csv", "wkt,blocks\nPOINT (1020 2050),1.000\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = points.csv");
    const Outcome outcome = call(project, "run scenario.ini --quiet");
    EXPECT_EQ(outcome.code, 4);
    EXPECT_NE(
        outcome.err.find("points.csv:2:19: found blocks '1.000', expected a whole number in [1, 1000000000]; "
                         "write 1000 without separators of thousands"),
        std::string::npos)
        << outcome.err;
}

}  // namespace
}  // namespace coupling::mistaken_input_test
