// `bannwald at`: what it prints of a place is what the cells of the rasters hold, and nothing else.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>

#include "config/grid/ascii_grid.hpp"
#include "config/text/numbers.hpp"
#include "tests/runs/hazard.hpp"
#include "tests/runs/program.hpp"

namespace coupling::place_values_test {
namespace {

constexpr const char* run = "run scenario.ini --quiet --set release.rocks=400";

/// What is printed of a raster under its folder: the word behind its name.
std::string printed(const std::string& answer, const std::string& folder, const std::string& raster) {
    std::istringstream lines{answer};
    std::string here;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        std::string name;
        std::string value;
        words >> name >> value;
        here = line.front() == ' ' ? here : name;
        if (line.front() == ' ' && here == folder && name == raster) {
            return value;
        }
    }
    return "nothing";
}

TEST(PlaceValues, AreThoseOfTheCell) {
    const SampleProject project;
    ASSERT_EQ(call(project, run).code, 0);
    int known = 0;
    int unknown = 0;
    for (const auto& [x_m, y_m] : {std::pair{1025.0, 2051.0}, std::pair{1044.0, 2051.0},
                                   std::pair{1071.5, 2058.0}, std::pair{1005.0, 2095.0}}) {
        const Outcome answer = call(project, "at out " + config::to_text(x_m) + " " + config::to_text(y_m));
        ASSERT_EQ(answer.code, 0) << answer.err;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(project.file("out/rasters"))) {
            if (entry.path().extension() != ".asc") {
                continue;
            }
            const std::string folder = "rasters/" + entry.path().parent_path().filename().string();
            const std::string stem = entry.path().stem().string();
            const config::Raster<double> grid =
                config::read_ascii_grid(project.read("out/" + folder + "/" + stem + ".asc"), stem);
            const double value = grid.at(grid.frame.cell_at(x_m, y_m));
            const std::string word = printed(answer.out, folder, stem);
            if (std::isnan(value)) {
                EXPECT_EQ(word, "-") << folder << "/" << stem;
                ++unknown;
                continue;
            }
            const auto shown = config::parse_number(word);
            ASSERT_TRUE(shown) << folder << "/" << stem << ": " << word;
            EXPECT_NEAR(*shown, value, 0.5e-3 * std::abs(value)) << folder << "/" << stem;
            ++known;
        }
    }
    EXPECT_GT(known, 0);
    EXPECT_GT(unknown, 0);
}

TEST(PlaceValues, SayUnitMeaningAndFewRocks) {
    const SampleProject project;
    ASSERT_EQ(call(project, std::string{run} + " --set release.rocks=8").code, 0);
    const Outcome answer = call(project, "at out 1044 2051");
    ASSERT_EQ(answer.code, 0) << answer.err;
    EXPECT_NE(answer.out.find(" kJ"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("largest energy of all rocks in the cell; on the bare slope"),
              std::string::npos)
        << answer.out;
    EXPECT_NE(answer.out.find("few rocks: "), std::string::npos) << answer.out;
}

TEST(PlaceValues, OfYearsHaveTheirMeaning) {
    const SampleProject project;
    ASSERT_EQ(shell(project,
                    "\"$bannwald\" init study --example regimes-small\n\"$bannwald\" run "
                    "study/scenario.ini --quiet --out out --set run.years=1 --set output.map_years=0 --set "
                    "run.replicates=1 --set release.rocks=100\n")
                  .code,
              0);
    const Outcome missed = call(project, "at out 0 0");
    ASSERT_EQ(missed.code, 4) << missed.err;
    // The middle of the map, out of the bounds that the message names.
    double west = 0.0;
    double east = 0.0;
    double south = 0.0;
    double north = 0.0;
    const std::string bounds = missed.err.substr(missed.err.find("X from"));
    ASSERT_EQ(
        std::sscanf(bounds.c_str(), "X from %lf to %lf, Y from %lf to %lf", &west, &east, &south, &north), 4)
        << missed.err;
    const Outcome answer = call(project, "at out " + config::to_text(0.5 * (west + east)) + " " +
                                             config::to_text(0.5 * (south + north)));
    ASSERT_EQ(answer.code, 0) << answer.err;
    EXPECT_NE(answer.out.find("Basal area; by patch in year N"), std::string::npos) << answer.out;
    EXPECT_NE(answer.out.find("rasters/rockfall/bare/year_0"), std::string::npos) << answer.out;
}

TEST(PlaceValues, OfAHazardRunAreThoseOfTheMapAndOfEachReturnPeriod) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, quick_hazard).code, 0);
    for (const char* place : {" 1044 2051", " 1005 2095"}) {
        const Outcome all = call(project, std::string{"at out"} + place);
        ASSERT_EQ(all.code, 0) << all.err;
        std::string joined;
        for (const char* folder :
             {"hazard", "return_period_10", "return_period_30", "return_period_100", "return_period_300"}) {
            const Outcome one = call(project, std::string{"at out/"} + folder + place);
            ASSERT_EQ(one.code, 0) << one.err;
            std::istringstream lines{one.out};
            for (std::string line; std::getline(lines, line);) {
                joined += (line.front() == ' ' ? "" : std::string{folder} + "/") + line + "\n";
            }
        }
        EXPECT_EQ(all.out, joined);
        const bool has_level = printed(all.out, "hazard/rasters/bare", "Hazard_level") != "-";
        EXPECT_EQ(has_level, std::string{place} == " 1044 2051");
        EXPECT_EQ(
            all.out.find("  no level: no rock of any return period passed this cell") != std::string::npos,
            !has_level)
            << all.out;
    }
    // A folder above names what is below it.
    const Outcome above = call(project, "at . 1044 2051");
    EXPECT_EQ(above.code, 3);
    std::filesystem::remove(project.file("out/hazard/summary.json"));
    const Outcome without_map = call(project, "at out 1044 2051");
    EXPECT_EQ(without_map.code, 3);
    EXPECT_NE(without_map.err.find("name the folder of a finished run: out/return_period_10, "
                                   "out/return_period_30, out/return_period_100 or out/return_period_300"),
              std::string::npos)
        << without_map.err;
}

TEST(PlaceValues, OfAHazardRunLeaveOutWhatIsNoPartOfTheMap) {
    const SampleProject project;
    add_blocks(project);
    ASSERT_EQ(call(project, quick_hazard).code, 0);
    project.replace("blocks.csv", "30,1,0.5\n", "");
    const Outcome again = call(project, quick_hazard);
    ASSERT_EQ(again.code, 0) << again.err;
    ASSERT_TRUE(std::filesystem::exists(project.file("out/return_period_30/summary.json")));
    ASSERT_EQ(shell(project, "cp -r out/return_period_10 out/kept").code, 0);
    const Outcome answer = call(project, "at out 1044 2051");
    ASSERT_EQ(answer.code, 0) << answer.err;
    for (const char* folder : {"hazard", "return_period_10", "return_period_100", "return_period_300"}) {
        EXPECT_NE(answer.out.find(std::string{folder} + "/rasters/"), std::string::npos) << folder;
    }
    EXPECT_EQ(answer.out.find("return_period_30/"), std::string::npos) << answer.out;
    EXPECT_EQ(answer.out.find("kept/"), std::string::npos) << answer.out;
}

TEST(PlaceValues, AreRefusedWhereThereAreNone) {
    const SampleProject project;
    ASSERT_EQ(call(project, run).code, 0);
    struct Refused {
        std::string arguments;
        int code;
        std::string message;
    };
    for (const Refused& refused :
         {Refused{"at out 1044", 2, "`bannwald at` with 2 words"},
          Refused{"at out 1044 a", 2, "'a', expected X and Y in metres"},
          Refused{"at out 1044 1,5", 2, "'1,5', expected X and Y in metres"},
          Refused{"at nowhere 1044 2051", 3, "no such file"},
          Refused{"at out -1044 -2051.5", 4, "no cell at -1044 -2051.5"},
          Refused{"at out 11.4 47.2", 4, "no cell at 11.4 47.2, expected X from 1000 to 1120"}}) {
        const Outcome outcome = call(project, refused.arguments);
        EXPECT_EQ(outcome.code, refused.code) << refused.arguments << "\n" << outcome.err;
        EXPECT_NE(outcome.err.find(refused.message), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    const std::string raster = project.read("out/rasters/bare/E_max.asc");
    project.write("out/rasters/bare/E_max.asc", raster.substr(0, raster.rfind(' ')) + " 1\n");
    const Outcome changed = call(project, "at out 1044 2051");
    EXPECT_EQ(changed.code, 4) << changed.err;
    EXPECT_NE(changed.err.find("E_max.asc: found a file that changed since its run"), std::string::npos)
        << changed.err;
}

}  // namespace
}  // namespace coupling::place_values_test
