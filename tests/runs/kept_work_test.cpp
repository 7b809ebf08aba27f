// What a run has computed is neither lost nor changed unseen: tables and parts that were damaged or mixed up,
// two runs in a folder, a run that ends while its results are written or put in their place.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::kept_work_test {
namespace {

namespace fs = std::filesystem;

/// A run of some parts on the bare slope, with a table of its rocks.
const std::string parts_with_table =
    "run scenario.ini --quiet --threads 2 --set trees.file= --set release.rocks=100000 "
    "--set run.rocks_per_part=25000 --set output.percentiles=no ";

/// Ends as soon as the first part is kept.
void keep_first_part(const SampleProject& project, const std::string& out) {
    const Outcome interrupted = shell(
        project, interrupted_once(out + "/parts/checkpoint.part", parts_with_table + "--out " + out, "KILL"));
    ASSERT_EQ(interrupted.code, 137) << interrupted.err;
    ASSERT_FALSE(fs::exists(project.file(out + "/summary.json")));
}

TEST(KeptTables, AreRefusedWhereTheirBytesHaveChanged) {
    const SampleProject project;
    keep_first_part(project, "out");
    ASSERT_EQ(shell(project,
                    "cp out/parts/rocks.csv kept.csv\n"
                    "dd if=/dev/zero of=out/parts/rocks.csv bs=4096 seek=100 count=1 conv=notrunc\n")
                  .code,
              0);
    const Outcome damaged = call(project, parts_with_table + "--out out");
    EXPECT_EQ(damaged.code, 3);
    EXPECT_NE(damaged.err.find("rocks.csv: found changed or damaged since its last finished part"),
              std::string::npos)
        << damaged.err;
    EXPECT_NE(damaged.err.find("restore it, or run with --overwrite"), std::string::npos) << damaged.err;
    EXPECT_FALSE(fs::exists(project.file("out/summary.json")));

    const Outcome restored =
        shell(project, "cp kept.csv out/parts/rocks.csv\n\"$bannwald\" " + parts_with_table +
                           "--out out || exit 1\n\"$bannwald\" " + parts_with_table +
                           "--out whole || exit 2\ndiff -r out whole\n");
    EXPECT_EQ(restored.code, 0) << restored.out << restored.err;
}

TEST(WritingResults, CanBeInterruptedAndIsAllThatIsDoneAgain) {
    const SampleProject project;
    const std::string run = parts_with_table + "--out out";
    const Outcome interrupted = shell(project, interrupted_once("out/.writing/results.gpkg", run));
    ASSERT_EQ(interrupted.code, 75) << interrupted.err;
    EXPECT_NE(interrupted.err.find("are kept"), std::string::npos) << interrupted.err;
    EXPECT_FALSE(fs::exists(project.file("out/.writing")));
    EXPECT_FALSE(fs::exists(project.file("out/summary.json")));
    ASSERT_TRUE(fs::exists(project.file("out/parts/rocks.csv")));
    // No rock falls again: the table is not touched from here on.
    const Outcome again =
        shell(project, "cp -p out/parts/rocks.csv kept.csv\n\"$bannwald\" " + run +
                           " || exit 1\ncmp kept.csv out/tables/rocks.csv || exit 2\n"
                           "[ ! out/tables/rocks.csv -nt kept.csv ] || exit 3\n\"$bannwald\" " +
                           parts_with_table + "--out whole || exit 4\ndiff -r out whole\n");
    EXPECT_EQ(again.code, 0) << again.out << again.err;
}

TEST(Publishing, IsFinishedByTheSameCommandAfterAKill) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet").code, 0);
    const Outcome outcome =
        shell(project,
              "cp -r out whole\nmkdir out/.complete\n"
              "mv out/summary.json out/rasters out/tables out/.complete\n"
              "\"$bannwald\" run scenario.ini\ncode=$?\ndiff -r out whole && exit $code\n");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("they are in their place now"), std::string::npos) << outcome.out;
}

TEST(Folder, IsThatOfOneRunAtATime) {
    const SampleProject project;
    const std::string run = "\"$bannwald\" " + parts_with_table + "--out out";
    const Outcome outcome =
        shell(project, run +
                           " &\nfirst=$!\n"
                           "while kill -0 $first && [ ! -e out/parts/checkpoint.part ]; do :; done\n" +
                           run + "; [ $? = 2 ] || exit 1\n" + run +
                           " --overwrite; [ $? = 2 ] || exit 2\n"
                           "kill -KILL $first; wait $first\n" +
                           run + " || exit 3\n\"$bannwald\" " + parts_with_table +
                           "--out whole || exit 4\ndiff -r out whole\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("another run of bannwald works in this output folder"), std::string::npos)
        << outcome.err;
}

TEST(Parts, AreRefusedUnderTheNameOfAnotherMember) {
    const ForestProject project;
    const std::string members = std::string{four_members} + "--set run.years=6 ";
    ASSERT_EQ(call(project, members + "--out shards --shard 1/2").code, 0);
    ASSERT_EQ(call(project, members + "--out shards --shard 2/2").code, 0);
    ASSERT_EQ(shell(project,
                    "cp -r shards mixed\ncp mixed/parts/member_1_1_1.part mixed/parts/member_2_1_1.part\n"
                    "cp -r shards bare\ncp bare/parts/bare_1_1.part bare/parts/bare_2_1.part\n"
                    "rm bare/parts/member_1_1_2.part\n")
                  .code,
              0);
    const Outcome mixed = call(project, members + "--out mixed");
    EXPECT_EQ(mixed.code, 3);
    EXPECT_NE(mixed.err.find(
                  "member_2_1_1.part: found the part of regime 1, climate 1, replicate 1, expected that of "
                  "regime 2, climate 1, replicate 1"),
              std::string::npos)
        << mixed.err;
    EXPECT_NE(mixed.err.find("delete it"), std::string::npos) << mixed.err;
    EXPECT_FALSE(fs::exists(project.file("mixed/summary.json")));

    const Outcome bare = call(project, members + "--out bare");
    EXPECT_EQ(bare.code, 3);
    EXPECT_NE(bare.err.find("bare_2_1.part: found falls over the bare slope of replicate 1"),
              std::string::npos)
        << bare.err;

    std::string merge = members.substr(members.find(' ') + 1);
    merge.insert(merge.find("scenario.ini") + std::string{"scenario.ini"}.size(), " mixed");
    const Outcome merged = call(project, "merge " + merge + "--out merged");
    EXPECT_EQ(merged.code, 3);
    EXPECT_NE(merged.err.find("the part of regime 1"), std::string::npos) << merged.err;
    EXPECT_EQ(merged.err.find("delete"), std::string::npos) << "not ours to delete: " << merged.err;
    EXPECT_FALSE(fs::exists(project.file("merged")));

    std::string overwritten = members.substr(members.find(' ') + 1);
    overwritten.insert(overwritten.find("scenario.ini") + std::string{"scenario.ini"}.size(), " shards");
    const Outcome refused = call(project, "merge " + overwritten + "--out shards --overwrite");
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("is that of a shard"), std::string::npos) << refused.err;
    EXPECT_TRUE(fs::exists(project.file("shards/parts/member_1_1_1.part")));
}

TEST(ArrivalTable, CanBeSwitchedOff) {
    const SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --quiet --out with").code, 0);
    ASSERT_EQ(call(project, "run scenario.ini --quiet --set output.arrivals=no --out without").code, 0);
    EXPECT_TRUE(fs::exists(project.file("with/tables/arrivals.csv")));
    EXPECT_FALSE(fs::exists(project.file("without/tables/arrivals.csv")));
    EXPECT_EQ(project.read("with/tables/targets.csv"), project.read("without/tables/targets.csv"));
    EXPECT_NE(project.read("with/results.gpkg").find("CREATE TABLE \"arrivals\""), std::string::npos);
    EXPECT_EQ(project.read("without/results.gpkg").find("CREATE TABLE \"arrivals\""), std::string::npos);
    EXPECT_EQ(project.read("without/summary.json").find("arrivals.csv"), std::string::npos);
}

}  // namespace
}  // namespace coupling::kept_work_test
