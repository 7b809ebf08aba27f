#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/motion_models.hpp"
#include "tests/runs/program.hpp"

namespace coupling::broken_off_test {
namespace {

namespace fs = std::filesystem;

/// A run of parts on the bare slope: the first ends after 20 000 rocks. Enough is left to be interrupted;
/// rocks of pir3d take more time.
std::string some_parts(const std::string& motion) {
    return "run scenario.ini --quiet --threads 2 --set trees.file= --set output.rock_table=no "
           "--set output.sample_paths=50 " +
           motion_settings(motion) +
           // A block takes a hundred times as long as a sphere that only jumps.
           (motion == "rigid"   ? "--set run.rocks_per_part=20 --set release.rocks=90"
            : motion == "pir3d" ? "--set run.rocks_per_part=20000 --set release.rocks=60000"
                                : "--set run.rocks_per_part=20000 --set release.rocks=100000");
}

std::string interrupted_after_first_part(const std::string& out, const std::string& run) {
    return interrupted_once(out + "/parts/checkpoint.part", run + " --out " + out);
}

TEST(FullDisk, EndsTheRunAndLeavesNothingBehind) {
    // A limit on the size of files fails as a full disk does: in the middle of writing.
    const SampleProject project;
    const Outcome outcome =
        shell(project, "trap '' XFSZ\nulimit -f 8\n\"$bannwald\" run scenario.ini --quiet\n");
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot be written"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(project.file("out")));
}

TEST(Interruption, LeavesNoResults) {
    const SampleProject project;
    const std::string run = "run scenario.ini --quiet --set release.rocks=100000000";
    const Outcome outcome = shell(project, interrupted_once("out", run));
    EXPECT_EQ(outcome.code, 75) << outcome.err;
    EXPECT_FALSE(fs::exists(project.file("out")));
    const Outcome at_once = shell(project, interrupted_at_once(run));
    EXPECT_EQ(at_once.code, 75) << at_once.err;
    EXPECT_NE(at_once.err.find("bannwald: interrupted"), std::string::npos) << at_once.err;
    EXPECT_FALSE(fs::exists(project.file("out")));
}

class InterruptionUnderModel : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Motion, InterruptionUnderModel, ::testing::ValuesIn(motion_model_names()),
                         [](const auto& model) { return model.param; });

TEST_P(InterruptionUnderModel, KeepsFinishedPartsForTheSameSettingsOnly) {
    const SampleProject project;
    // On the sample's soil, whose friction is the tangent of its slope, rocks of pir3d creep: a run would
    // take minutes. On this one most pass and some come to rest.
    project.replace("surface_types.csv", "vegetated_soil_step_1", "soft_soil_step_2");
    // A short net, so that its table stays small.
    project.write("nets.csv",
                  "name,height_m,capacity_kj,wkt\nshort,3,50,\"LINESTRING (1098 2045, 1098 2049)\"\n");
    const std::string run = some_parts(GetParam()) + " --set nets.file=nets.csv";
    const Outcome interrupted = shell(project, interrupted_after_first_part("out", run));
    ASSERT_EQ(interrupted.code, 75) << interrupted.err;
    ASSERT_TRUE(fs::exists(project.file("out/parts")));
    EXPECT_FALSE(fs::exists(project.file("out/report.html")));

    const Outcome other = call(project, run + " --seed 2");
    EXPECT_EQ(other.code, 2) << other.err;
    EXPECT_TRUE(fs::exists(project.file("out/parts")));

    EXPECT_EQ(call(project, run).code, 0);
    EXPECT_EQ(call(project, run + " --out whole").code, 0);
    for (const std::string name :
         {"rasters/bare/E_95.asc", "rasters/bare/Nr_passages.asc", "tables/targets.csv", "tables/nets.csv",
          "tables/net_crossings.csv", "tables/trajectories.csv", "report.html"}) {
        EXPECT_EQ(project.read("out/" + name), project.read("whole/" + name)) << name;
        EXPECT_NE(project.read("out/" + name), "") << name;
    }
    EXPECT_FALSE(fs::exists(project.file("out/parts")));
}

/// A line with many rocks is one source: it is parted too, and an interruption keeps what has fallen since.
TEST(Interruption, GoesOnWithinASource) {
    const SampleProject project;
    project.write("lines.csv", "blocks,wkt\n100000,\"LINESTRING (1025 2035, 1025 2065)\"\n");
    project.replace("scenario.ini", "source = source.asc", "source_shapes = lines.csv");
    const std::string run =
        "run scenario.ini --quiet --threads 2 --set trees.file= --set output.rock_table=no "
        "--set run.rocks_per_part=25000 --set \"output.path_rocks=3, 74999, 99999\"";
    const Outcome outcome =
        shell(project, "\"$bannwald\" " + run +
                           " --out out &\n"
                           "part=out/parts/checkpoint.part\n"
                           "while kill -0 $! && [ ! -e $part ]; do sleep 0.01; done\n"
                           "cp $part first\nkill -TERM $!\nwait $!\n[ $? = 75 ] || exit 1\n"
                           "cmp -s $part first && exit 2\n"
                           "\"$bannwald\" " +
                           run + " --out out || exit 3\n\"$bannwald\" " + run +
                           " --out whole || exit 4\ndiff -r out whole\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace coupling::broken_off_test
