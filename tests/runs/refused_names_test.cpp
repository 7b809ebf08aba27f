// Names that the file system refuses, and what the system does to a process: answered with the documented
// exit codes.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "coupling/inputs/scenario/scenario.hpp"
#include "tests/runs/program.hpp"

namespace coupling::refused_names_test {
namespace {

/// Three hundred letters: more than a file name may have.
const std::string too_long(300, 'n');

/// A call with the name in question in place of NAME.
struct NameGiven {
    std::string title;
    std::string arguments;
};

void PrintTo(const NameGiven& given, std::ostream* out) {
    *out << given.title;
}

const NameGiven names_given[] = {
    {"Scenario", "run NAME"},
    {"ScenarioToCheck", "check NAME"},
    {"OutputFolder", "run scenario.ini --quiet --out NAME"},
    {"FolderBelowIt", "run scenario.ini --quiet --out NAME/out"},
    {"OverwrittenFolder", "run scenario.ini --quiet --overwrite --out NAME"},
    {"NewProject", "init NAME"},
    {"FolderOfRockyfor3d", "init new --from-rockyfor3d NAME"},
    {"RunToCompare", "compare NAME NAME"},
    {"RunWithStoredPaths", "net try NAME --nets targets.csv"},
    {"FolderOfStoppingTable", "stopping-table --out NAME"},
    {"RecipeOfStoppingTable", "stopping-table NAME --out new"},
    {"FolderOfCases", "validate --cases NAME"},
    {"FolderOfVerdicts", "validate bad_ischl --out NAME"},
    {"AnyFile", "info NAME"},
    {"Terrain", "run scenario.ini --quiet --set terrain.dem=NAME"},
    {"Grounds", "run scenario.ini --quiet --set terrain.surface=NAME"},
    {"GroundTable", "run scenario.ini --quiet --set terrain.surface_types=NAME"},
    {"Trees", "run scenario.ini --quiet --set trees.file=NAME"},
    {"Logs", "run scenario.ini --quiet --set trees.logs=NAME"},
    {"Sources", "run scenario.ini --quiet --set release.source=NAME"},
    {"Targets", "run scenario.ini --quiet --set targets.file=NAME"},
    {"Nets", "run scenario.ini --quiet --set nets.file=NAME"},
    {"Blocks", "run scenario.ini --quiet --set hazard.blocks=NAME"},
};

class RefusedName : public ::testing::TestWithParam<NameGiven> {
protected:
    static void expect_refused(const SampleProject& project, const std::string& name) {
        std::string arguments = GetParam().arguments;
        for (std::size_t at = arguments.find("NAME"); at != std::string::npos; at = arguments.find("NAME")) {
            arguments.replace(at, 4, name);
        }
        const Outcome outcome = call(project, arguments);
        EXPECT_EQ(outcome.code, 3) << outcome.err;
        EXPECT_NE(outcome.err.find(name.substr(0, 40)), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.err.find("fault of the program"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find(", expected "), std::string::npos) << outcome.err;
    }
};
INSTANTIATE_TEST_SUITE_P(Of, RefusedName, ::testing::ValuesIn(names_given),
                         [](const auto& given) { return given.param.title; });

TEST_P(RefusedName, OfThreeHundredLettersIsNamed) {
    const SampleProject project;
    expect_refused(project, too_long);
}

TEST_P(RefusedName, ThatLeadsInACircleIsNamed) {
    const SampleProject project;
    std::filesystem::create_symlink("circle", project.file("circle"));
    expect_refused(project, "circle");
}

TEST(LimitOnFileSizes, IsAnsweredAsAFullDisk) {
    // The signal that comes with such a limit would end the program without a word.
    const SampleProject project;
    const Outcome outcome = shell(project, "ulimit -f 8\n\"$bannwald\" run scenario.ini --quiet\n");
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot be written: File too large"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("out")));
}

}  // namespace
}  // namespace coupling::refused_names_test
