#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/calibrations.hpp"
#include "tests/runs/hazard.hpp"
#include "tests/runs/years.hpp"

namespace coupling::ranks_test {
namespace {

/// As root in a container, with more ranks than processors; libraries of MPI keep memory to their end.
const std::string mpirun =
    "export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1\n"
    "export OMPI_MCA_hwloc_base_binding_policy=none ASAN_OPTIONS=detect_leaks=0\n"
    "ranks() { n=$1; shift; mpirun -n $n \"$bannwald\" \"$@\"; }\n";

bool without_mpi() {
    return call(SampleProject{}, "--version").out.find("without MPI") != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& words) {
    std::size_t found = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        ++found;
    }
    return found;
}

/// Runs over years on several ranks.
class Ranks : public ::testing::Test {
protected:
    void SetUp() override {
        if (without_mpi()) {
            GTEST_SKIP() << "built without MPI";
        }
    }
    [[nodiscard]] Outcome with_ranks(const std::string& script) const {
        return shell(project_, mpirun + script);
    }
    ForestProject project_;
};

const std::string members = std::string{four_members} + "--set run.years=6 ";

TEST_F(Ranks, OfAnyNumberGiveTheBytesOfOneProcess) {
    ASSERT_EQ(call(project_, members + "--out whole").code, 0);
    for (const std::string n : {"1", "2", "4"}) {
        const Outcome outcome = with_ranks("ranks " + n + " " + members + "--out with_" + n +
                                           " || exit 1\ndiff -r whole with_" + n + "\n");
        EXPECT_EQ(outcome.code, 0) << n << " ranks\n" << outcome.out << outcome.err;
    }
}

TEST_F(Ranks, OfRigidBlocksGiveTheBytesOfOneProcess) {
    const std::string blocks = std::string{four_members} +
                               "--set run.years=2 --set release.rocks=8 --set rockfall.motion=rigid --set "
                               "release.shape=cube,plate,sphere ";
    ASSERT_EQ(call(project_, blocks + "--out whole").code, 0);
    const Outcome outcome =
        with_ranks("ranks 3 " + blocks + "--out with_3 || exit 1\ndiff -r whole with_3\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(Ranks, ShareTheMembersOfAShard) {
    ASSERT_EQ(call(project_, members + "--out whole").code, 0);
    const Outcome outcome = with_ranks("ranks 2 " + members +
                                       "--out out --shard 1/2 || exit 1\n"
                                       "ls out/parts/member_*.part | wc -l\n"
                                       "ranks 2 " +
                                       members +
                                       "--out out || exit 2\n"
                                       "diff -r whole out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("2\n"), std::string::npos) << outcome.out;
}

TEST_F(Ranks, SayOnceWhatIsWrongAndLeaveTogether) {
    const Outcome outcome = with_ranks("ranks 3 run scenario.ini --set run.years=0.5\n");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(count(outcome.err, "bannwald: "), 1U) << outcome.err;
    const Outcome missing = with_ranks("ranks 3 run scenario.ini --set climate.file=none.csv\n");
    EXPECT_EQ(missing.code, 3) << missing.err;
    EXPECT_EQ(count(missing.err, "bannwald: "), 1U) << missing.err;
    EXPECT_FALSE(std::filesystem::exists(project_.file("out")));
}

TEST_F(Ranks, EndAllWithTheCodeOfTheOneThatFailed) {
    // The second rank reads another scenario than the first.
    const Outcome outcome = with_ranks(
        "cat > other.sh <<'END'\n"
        "if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then exec \"$1\" run scenario.ini --quiet --seed 5; fi\n"
        "exec \"$1\" run scenario.ini --quiet\n"
        "END\n"
        "mpirun -n 2 sh other.sh \"$bannwald\"\n");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(count(outcome.err, "processes of one run with different settings"), 1U) << outcome.err;
}

/// Started by a launcher that the program's MPI does not speak with, each process would do the whole run.
TEST_F(Ranks, ThatDoNotFindEachOtherSaySo) {
    const Outcome outcome = shell(
        project_, "PMI_SIZE=2 PMI_RANK=0 OMPI_ALLOW_RUN_AS_ROOT=1 \"$bannwald\" run scenario.ini --quiet\n");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project_.file("out")));
}

/// Rocks of several chunks.
const std::string today =
    "run scenario.ini --set run.years=0 --set release.rocks_per_source=1500 --set output.sample_paths=40 ";

TEST_F(Ranks, ShareTheRocksOfToday) {
    const SampleProject project;
    ASSERT_EQ(call(project, today + "--out whole").code, 0);
    for (const std::string n : {"2", "3"}) {
        const Outcome outcome = shell(project, mpirun + "ranks " + n + " " + today + "--out with_" + n +
                                                   " || exit 1\ndiff -r whole with_" + n + "\n");
        EXPECT_EQ(outcome.code, 0) << n << " ranks\n" << outcome.out << outcome.err;
    }
    const Outcome shards =
        shell(project, mpirun + "ranks 2 " + today + "--shard 2/2 --out out || exit 1\n" + "ranks 3 " +
                           today + "--out out || exit 2\ndiff -r whole out\n");
    EXPECT_EQ(shards.code, 0) << shards.out << shards.err;
}

/// One process, then three, into folders of the same name: comparisons name them.
std::string one_and_three(const std::string& command) {
    return "rm -rf out whole\n\"$bannwald\" " + command + "--out out || exit 1\nmv out whole\nranks 3 " +
           command + "--out out || exit 2\ndiff -r whole out\n";
}

/// A process then does one run after the other, each shared for itself.
TEST_F(Ranks, ShareTheRocksOfEachReturnPeriodAndOfEachModel) {
    const SampleProject project;
    add_blocks(project);
    const std::string hazard = "run scenario.ini --set release.rocks_per_source=300 ";
    for (const std::string models : {"", "--motion picus,pir3d "}) {
        const Outcome outcome = shell(project, mpirun + one_and_three(hazard + models));
        EXPECT_EQ(outcome.code, 0) << models << '\n' << outcome.out << outcome.err;
    }
    const Outcome again = shell(project, mpirun + "ranks 2 " + hazard + "--out out\n");
    EXPECT_EQ(again.code, 2) << "of two models\n" << again.err;
}

TEST_F(Ranks, ShareTheMembersOfEachModel) {
    const std::string models = members + "--set run.years=2 --motion picus,classical ";
    const Outcome outcome = with_ranks(one_and_three(models));
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(Ranks, ShareTheSetsOfACalibration) {
    const SampleProject project;
    const Outcome stops = shell(
        project,
        "\"$bannwald\" run scenario.ini --quiet --out truth --set release.rocks_per_source=30 || exit 1\n"
        "awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; print \"x_m,y_m\"; next }\n"
        "NR % 5 == 0 { print $column[\"x_end_m\"] \",\" $column[\"y_end_m\"] }' truth/tables/rocks.csv > "
        "stops.csv\nprintf '[observed]\\nstops = stops.csv\\n' >> scenario.ini\n");
    ASSERT_EQ(stops.code, 0) << stops.err;
    for (const std::string emulator : {"no", "yes"}) {
        const Outcome outcome = shell(
            project, mpirun + one_and_three("calibrate scenario.ini --set calibrate.sets=60 "
                                            "--set calibrate.first_sets=64 --set calibrate.most_sets=300 "
                                            "--set calibrate.rocks=60 --set calibrate.emulator=" +
                                            emulator + " "));
        EXPECT_EQ(outcome.code, 0) << emulator << outcome.out << outcome.err;
    }
}

/// The first one judges alone, the sites and what the others predict for each, while the other waits.
TEST_F(Ranks, ShareTheSetsOfACalibrationOfSitesAndOfItsTransfers) {
    const SampleProject project;
    simulate_truth(project, "", "set,weight,losses\n1,1,1.3\n");
    write_stops(project, "");
    const Outcome outcome = shell(
        project,
        mpirun +
            "printf '[observed]\\nstops = stops.csv\\n' >> scenario.ini\nmkdir other\n"
            "for file in *; do [ -f $file ] && cp $file other; done\necho 1070,2050 >> other/stops.csv\n"
            "command='calibrate scenario.ini --set calibrate.sites=other/scenario.ini "
            "--set calibrate.sets=50 --set calibrate.first_sets=64 --set calibrate.most_sets=300 "
            "--set calibrate.rocks=60'\n"
            "\"$bannwald\" $command --out out || exit 1\nmv out whole\nranks 2 $command --out out || exit 2\n"
            "[ -e out/tables/transfer.csv ] || exit 3\ndiff -r whole out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

/// Ctrl-C reaches one process alone: the others hear of it while they try their sets.
TEST_F(Ranks, KeepTheSetsOfACalibrationWhenOneIsInterrupted) {
    const SampleProject project;
    simulate_truth(project, "", "set,weight,losses\n1,1,1.3\n");
    write_stops(project, "");
    const std::string calibration =
        "calibrate scenario.ini --threads 1 --set observed.stops=stops.csv --set calibrate.sets=200 "
        "--set calibrate.first_sets=512 --set calibrate.most_sets=4000 --set calibrate.rocks=200 ";
    const Outcome outcome = shell(
        project,
        mpirun +
            // A machine may be faster than the signal, but not twenty times.
            "code=0\nfor i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do\nrm -rf out\n"
            "mpirun -n 2 sh -c 'echo $$ > rank_$OMPI_COMM_WORLD_RANK; exec \"$0\" \"$@\"' \"$bannwald\" " +
            calibration +
            "--out out &\n"
            "while kill -0 $! 2>/dev/null && ! ls out/parts/search.part >/dev/null 2>&1; do sleep 0.01; "
            "done\n"
            "kill -INT $(cat rank_1)\nwait $!\n"
            "code=$?\n[ $code -eq 75 ] && break\ndone\n"
            "[ $code -eq 75 ] || exit 1\nls out/parts/search.part || exit 2\n"
            "ranks 2 " +
            calibration + "--out out || exit 3\n\"$bannwald\" " + calibration +
            "--out whole || exit 4\n"
            "diff -r -x .bannwald whole out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(Ranks, LeaveAHazardMapTogether) {
    const SampleProject project;
    add_blocks(project);
    const Outcome outcome =
        shell(project, mpirun + "mkdir out\ntouch out/summary.json\nranks 3 run scenario.ini --out out\n");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(count(outcome.err, "finished results of another run"), 1U) << outcome.err;
}

TEST_F(Ranks, LeaveOtherCommandsToTheFirst) {
    const Outcome outcome = with_ranks("ranks 2 --version\n");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(count(outcome.out, "licence"), 1U) << outcome.out;
}

TEST_F(Ranks, LeaveFinishedMembersWhenOneIsKilled) {
    // Killed are the processes that mpirun started, one of them, as soon as a member is through.
    const std::string longer = members + "--set run.years=60 --threads 1 ";
    const Outcome outcome = with_ranks(
        "mpirun -n 2 sh -c 'echo $$ > rank_$OMPI_COMM_WORLD_RANK; exec \"$0\" \"$@\"' \"$bannwald\" " +
        longer +
        "--out out &\n"
        "while kill -0 $! 2>/dev/null && ! ls out/parts/member_*.part >/dev/null 2>&1; do sleep 0.01; done\n"
        "kill -KILL $(cat rank_1)\nwait $!\n"
        "[ $? -ne 0 ] || exit 1\n"
        "ls out/parts/member_*.part || exit 2\n"
        "[ ! -e out/summary.json ] || exit 3\n"
        "ranks 2 " +
        longer + "--out out || exit 4\n\"$bannwald\" " + longer +
        "--out whole || exit 5\n"
        "diff -r whole out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST_F(Ranks, KeepFinishedMembersWhenInterrupted) {
    const std::string longer = members + "--set run.years=60 --threads 1 ";
    const Outcome outcome = with_ranks(
        "mpirun -n 2 sh -c 'echo $$ > rank_$OMPI_COMM_WORLD_RANK; exec \"$0\" \"$@\"' \"$bannwald\" " +
        longer +
        "--out out &\n"
        "while kill -0 $! 2>/dev/null && ! ls out/parts/member_*.part >/dev/null 2>&1; do sleep 0.01; done\n"
        "kill -TERM $(cat rank_1)\nwait $!\n");
    EXPECT_EQ(outcome.code, 75) << outcome.err;
    EXPECT_EQ(count(outcome.err, "bannwald: interrupted; the finished parts are kept"), 1U) << outcome.err;
}

TEST(WithoutMpi, SeveralProcessesAreRefused) {
    if (!without_mpi()) {
        GTEST_SKIP() << "built with MPI";
    }
    const ForestProject project;
    const Outcome outcome = shell(project, "OMPI_COMM_WORLD_SIZE=2 \"$bannwald\" run scenario.ini\n");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("2 processes started to share a run"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace coupling::ranks_test
