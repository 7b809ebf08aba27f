#include "coupling/inputs/scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/coupling/inputs/opened.hpp"

namespace coupling::scenario_test {
namespace {

using config::ExitCode;

std::string errors_of(const std::vector<std::string>& overrides) {
    const SampleProject project;
    const Opened opened = open(project, overrides);
    EXPECT_EQ(opened.code, ExitCode::settings) << opened.errors;
    return opened.errors;
}

TEST(Scenario, FindsFilesBesideItself) {
    Scenario scenario;
    scenario.file = "/projects/lech/scenario.ini";
    EXPECT_EQ(scenario.resolve("dem.asc"), "/projects/lech/dem.asc");
    EXPECT_EQ(scenario.resolve("/data/dem.asc"), "/data/dem.asc");
}

TEST(Scenario, NamesFilesByTheShortestWayThatIsTheSame) {
    const SampleProject project;
    namespace fs = std::filesystem;
    fs::create_directories(project.file("a/b"));
    fs::create_directory_symlink(project.file("a/b"), project.file("link"));
    Scenario scenario;
    scenario.file = project.file("a/scenario.ini");
    EXPECT_EQ(scenario.resolve("../dem.asc"), project.file("dem.asc"));
    // Behind a link the way up leads to a/, not to the project.
    scenario.file = project.file("link/scenario.ini");
    EXPECT_EQ(scenario.resolve("../dem.asc"), project.file("link/../dem.asc"));
}

TEST(Scenario, ThatIsMissingIsAMissingFile) {
    const SampleProject project;
    project.remove("scenario.ini");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, ExitCode::file);
}

TEST(Scenario, TellsUnknownKeysWithTheNearestKnown) {
    const SampleProject project;
    project.replace("scenario.ini", "diameter_m", "diametre_m");
    const Opened opened = open(project);
    EXPECT_EQ(opened.code, ExitCode::settings);
    EXPECT_NE(opened.errors.find("scenario.ini:10"), std::string::npos) << opened.errors;
    EXPECT_NE(opened.errors.find("release.diameter_m"), std::string::npos) << opened.errors;
}

TEST(Scenario, RefusesRocksWithoutSize) {
    EXPECT_NE(errors_of({"release.diameter_m=0"}).find("[0.01, 20]"), std::string::npos);
    EXPECT_NE(errors_of({"release.density_kgpm3=2.7"}).find("[1000, 5000]"), std::string::npos);
}

TEST(Scenario, RefusesListsOfDifferentLength) {
    EXPECT_NE(errors_of({"release.diameter_kind=classes", "release.diameter_classes_m=0.5 1",
                         "release.diameter_shares=1 2 3"})
                  .find("found 3 shares for 2 diameters, expected as many of both"),
              std::string::npos);
    EXPECT_NE(errors_of({"release.diameter_kind=classes"}).find("no release.diameter_classes_m"),
              std::string::npos);
}

TEST(Scenario, RefusesRangesThatHoldNothing) {
    EXPECT_NE(
        errors_of({"release.diameter_kind=uniform", "release.diameter_low_m=2", "release.diameter_high_m=1"})
            .find("expected more than release.diameter_low_m 2"),
        std::string::npos);
    EXPECT_NE(errors_of({"release.diameter_kind=lognormal", "release.diameter_low_m=0.2",
                         "release.diameter_high_m=1"})
                  .find("release.diameter_deviation_m"),
              std::string::npos);
}

TEST(Scenario, RefusesAReleaseWithoutRocks) {
    EXPECT_NE(errors_of({"release.rocks_per_source=0"}).find("no rocks"), std::string::npos);
}

TEST(Scenario, RefusesInputsThatExcludeEachOther) {
    EXPECT_NE(errors_of({"terrain.points=p.xyz"}).find("found terrain.points beside terrain.dem"),
              std::string::npos);
    EXPECT_NE(errors_of({"terrain.dem="}).find("neither terrain.dem nor terrain.points"), std::string::npos);
    EXPECT_NE(errors_of({"release.source="}).find("neither release.source nor release.source_shapes"),
              std::string::npos);
    EXPECT_NE(errors_of({"terrain.surface_types="}).find("without terrain.surface_types"), std::string::npos);
    // Codes that nothing explains would stop no rock.
    EXPECT_NE(errors_of({"terrain.surface=", "terrain.surface_types=", "terrain.ground=pasture",
                         "terrain.stopping=s.csv"})
                  .find("found terrain.stopping without terrain.surface_types"),
              std::string::npos);
}

TEST(Scenario, TellsAllProblemsAtOnce) {
    const std::string errors = errors_of({"release.source=", "run.years=30", "release.rocks_per_source=0"});
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 4) << errors;
}

TEST(StartLaw, DropsRocksFromTheFallHeight) {
    Scenario scenario;
    scenario.release.start_dip_deg = 45.0;
    EXPECT_EQ(start_law(scenario.release).height_m, 1.5);
    EXPECT_EQ(start_law(scenario.release).speed_mps, 3.0);
    EXPECT_DOUBLE_EQ(start_law(scenario.release).dip.in_degrees(), 45.0);
    scenario.release.fall_height_m = 12.0;
    EXPECT_EQ(start_law(scenario.release).height_m, 12.0);
    EXPECT_EQ(start_law(scenario.release).speed_mps, 0.0);
}

TEST(StartLaw, LeavesOutClassesThatNeverOccur) {
    Scenario scenario;
    scenario.release.diameter_kind = DiameterKind::classes;
    scenario.release.diameter_classes_m = {0.5, 1.0, 3.0};
    scenario.release.diameter_shares = {3.0, 1.0, 0.0};
    const rockfall::DiameterLaw law = start_law(scenario.release).diameter;
    EXPECT_EQ(law.at(0.7), 0.5);
    EXPECT_EQ(law.at(0.8), 1.0);
    EXPECT_EQ(law.largest_m(), 1.0);
}

TEST(Scenario, RefusesFilesThatAreNotThereAlsoWhereTheRunReadsThemNot) {
    const SampleProject project;
    for (const char* key : {"stands.records", "climate.file", "soil.map"}) {
        const Opened opened = open(project, {std::string{key} + "=nan"});
        EXPECT_EQ(opened.code, ExitCode::file) << key;
        EXPECT_NE(opened.errors.find(std::string{key} + ", which names no file: 'nan'"), std::string::npos)
            << opened.errors;
    }
    project.write("records.csv", "stand\n");
    EXPECT_EQ(open(project, {"stands.records=records.csv"}).code, ExitCode::done);
    // A file that is read and not there is one problem.
    const Opened opened = open(project, {"trees.file=gone.csv"});
    EXPECT_EQ(opened.errors.find("which names no file"), std::string::npos) << opened.errors;
}

}  // namespace
}  // namespace coupling::scenario_test
