#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/hazard.hpp"
#include "tests/runs/nets.hpp"
#include "tests/runs/years.hpp"

namespace coupling::shards_test {
namespace {

const std::string members = std::string{four_members} + "--set run.years=6 ";

TEST(Shards, InOneFolderGiveTheBytesOfAWholeRun) {
    const ForestProject project;
    ASSERT_EQ(call(project, members + "--out whole").code, 0);
    for (const std::string shard : {"2/3", "1/3", "3/3"}) {
        ASSERT_EQ(call(project, members + "--out out --shard " + shard).code, 0);
    }
    ASSERT_EQ(call(project, members + "--out out").code, 0);
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
}

/// Fewer rocks with shapes: each takes a hundred times as long.
std::string of_blocks(const std::string& shapes) {
    return std::string{four_members} +
           "--set run.years=2 --set release.rocks=8 --set rockfall.motion=rigid --set release.shape=" +
           shapes + " ";
}

TEST(Shards, OfRigidBlocksGiveTheBytesOfAWholeRunOnAnyNumberOfThreads) {
    const ForestProject project;
    ASSERT_EQ(call(project, of_blocks("cube,plate,sphere") + "--threads 1 --out whole").code, 0);
    ASSERT_EQ(call(project, of_blocks("cube,plate,sphere") + "--threads 3 --out out --shard 2/2").code, 0);
    ASSERT_EQ(call(project, of_blocks("cube,plate,sphere") + "--threads 2 --out out").code, 0);
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
    // Rocks fell: the same run with other shapes has other bytes.
    ASSERT_EQ(call(project, of_blocks("sphere") + "--out spheres").code, 0);
    EXPECT_NE(project.read("spheres/tables/regimes_by_year.csv"),
              project.read("whole/tables/regimes_by_year.csv"));
}

TEST(Shards, SideBySideInOneFolderShareTheirPartsAndSurviveAKill) {
    const ForestProject project;
    ASSERT_EQ(call(project, members + "--out whole").code, 0);
    const std::string shard = "\"$bannwald\" " + members + "--threads 1 --out out --shard ";
    const Outcome outcome =
        shell(project, shard + "1/3 & first=$!\n" + shard + "2/3 & second=$!\n" + shard +
                           "3/3 & third=$!\n"
                           "while kill -0 $third 2>/dev/null && ! ls out/parts/bare_*.part "
                           ">/dev/null 2>&1; do :; done\n"
                           "kill -KILL $third\nwait $third\n"
                           "wait $first || exit 1\nwait $second || exit 2\n" +
                           shard + "3/3 || exit 3\n\"$bannwald\" " + members +
                           "--out out || exit 4\ndiff -r whole out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

/// The same settings for another command: what follows `run`.
std::string merge(const std::string& folders_and_options) {
    std::string words = members.substr(members.find(' ') + 1);
    words.insert(words.find("scenario.ini") + std::string{"scenario.ini"}.size(), " " + folders_and_options);
    return "merge " + words;
}

TEST(Shards, MergedFromTheirFoldersGiveTheBytesOfAWholeRun) {
    const ForestProject project;
    ASSERT_EQ(call(project, members + "--out whole").code, 0);
    ASSERT_EQ(call(project, members + "--out first --shard 1/2").code, 0);
    ASSERT_EQ(call(project, members + "--out second --shard 2/2").code, 0);
    const Outcome merged = call(project, merge("first second --out out"));
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
}

TEST(Shards, AreNotMergedWithGapsNorWithOtherSettings) {
    const ForestProject project;
    ASSERT_EQ(call(project, members + "--out first --shard 1/2").code, 0);
    const Outcome gaps = call(project, merge("first --out out"));
    EXPECT_EQ(gaps.code, 3);
    EXPECT_NE(gaps.err.find("2 members without a part"), std::string::npos) << gaps.err;
    // The call that it names fills the gap, and only that.
    EXPECT_NE(gaps.err.find("`bannwald run SCENARIO --out out` with the same settings"), std::string::npos)
        << gaps.err;
    const Outcome filled = call(project, members + "--out out");
    ASSERT_EQ(filled.code, 0) << filled.err;
    ASSERT_EQ(call(project, members + "--out whole").code, 0);
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
    const Outcome other = call(project, merge("first --out other --seed 7"));
    EXPECT_EQ(other.code, 3);
    EXPECT_NE(other.err.find("a part of a run with other settings or inputs"), std::string::npos)
        << other.err;
    const Outcome none = call(project, merge("nowhere --out third"));
    EXPECT_EQ(none.code, 3);
    EXPECT_NE(none.err.find("no parts in this folder"), std::string::npos) << none.err;
}

TEST(Shards, OfTodayNeedAMapOfTheirOwn) {
    const SampleProject project;
    EXPECT_EQ(call(project, "run scenario.ini --shard 3/2").code, 2);
    const Outcome outcome =
        call(project, "run scenario.ini --shard 1/2 --set tree_impact.remove_broken=yes --out out");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("in a run that is shared out"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("out")));
}

/// Rocks of several chunks, and everything that a run of today counts and writes row by row.
const std::string today =
    "scenario.ini --set release.rocks_per_source=1500 --set output.sample_paths=40 --set output.repeats=3 "
    "--set run.rocks_per_part=700 ";

SampleProject& with_nets(SampleProject& project) {
    add_nets(project);
    return project;
}

TEST(ShardsOfToday, InOneFolderGiveTheBytesOfAWholeRun) {
    SampleProject project;
    with_nets(project);
    ASSERT_EQ(call(project, "run " + today + "--out whole").code, 0);
    for (const std::string shard : {"2/4", "4/4", "1/4", "3/4"}) {
        ASSERT_EQ(call(project, "run " + today + "--threads 2 --out out --shard " + shard).code, 0);
    }
    ASSERT_EQ(call(project, "run " + today + "--out out").code, 0);
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
}

TEST(ShardsOfToday, MayBeMoreThanTheRocksFill) {
    SampleProject project;
    ASSERT_EQ(call(project, "run scenario.ini --out whole").code, 0);
    for (const std::string shard : {"1/3", "2/3"}) {
        ASSERT_EQ(call(project, "run scenario.ini --out out --shard " + shard).code, 0);
    }
    // What is missing is simulated.
    ASSERT_EQ(call(project, "run scenario.ini --out out").code, 0);
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
}

TEST(ShardsOfToday, MergedFromTheirFoldersGiveTheBytesOfAWholeRun) {
    SampleProject project;
    with_nets(project);
    ASSERT_EQ(call(project, "run " + today + "--out whole").code, 0);
    ASSERT_EQ(call(project, "run " + today + "--out a --shard 1/2").code, 0);
    const std::string merge = "merge scenario.ini " + today.substr(today.find("--"));
    const Outcome gap = call(project, merge + "a --out out");
    EXPECT_EQ(gap.code, 3);
    EXPECT_NE(gap.err.find("no piece 2 of 2"), std::string::npos) << gap.err;
    EXPECT_NE(gap.err.find("--shard 2/2"), std::string::npos) << gap.err;
    ASSERT_EQ(call(project, "run " + today + "--out b --shard 2/2").code, 0);
    const Outcome merged = call(project, merge + "b a --out out");
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
    const Outcome other = call(project, merge + "a b --seed 7 --out other");
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("parts of a run with other settings"), std::string::npos) << other.err;
    const Outcome parted = call(project, "run " + today + "--out a --shard 2/3");
    EXPECT_EQ(parted.code, 2);
    EXPECT_NE(parted.err.find("found shards and processes for 3 pieces, expected those of the parts in this "
                              "folder: 2 pieces, with as many shards and processes as before"),
              std::string::npos)
        << parted.err;
}

TEST(ShardsOfToday, SurviveAKill) {
    SampleProject project;
    ASSERT_EQ(call(project, "run " + today + "--out whole").code, 0);
    // Killed once the first part of the shard is on the disk.
    const Outcome outcome =
        shell(project, "\"$bannwald\" run " + today +
                           "--threads 1 --out out --shard 1/2 & first=$!\n"
                           "while kill -0 $first 2>/dev/null && ! ls out/parts/piece_1_of_2/checkpoint.part "
                           ">/dev/null 2>&1; do :; done\n"
                           "kill -KILL $first\nwait $first\n"
                           "\"$bannwald\" run " +
                           today + "--out out --shard 2/2 || exit 1\n\"$bannwald\" run " + today +
                           "--out out || exit 2\ndiff -r whole out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Shards, OfAHazardMapGiveTheBytesOfAWholeRunInOneFolderOrSeveral) {
    const SampleProject project;
    add_blocks(project);
    const std::string settings = "--quiet --set release.rocks_per_source=300 ";
    const std::string hazard = "run scenario.ini " + settings;
    ASSERT_EQ(call(project, hazard + "--out whole").code, 0);
    ASSERT_EQ(call(project, hazard + "--out out --shard 2/2").code, 0);
    EXPECT_FALSE(std::filesystem::exists(project.file("out/hazard")));
    ASSERT_EQ(call(project, hazard + "--out out").code, 0);
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);

    ASSERT_EQ(call(project, hazard + "--out first --shard 1/2").code, 0);
    const Outcome gaps = call(project, "merge scenario.ini first --out merged " + settings);
    EXPECT_EQ(gaps.code, 3) << gaps.err;
    EXPECT_FALSE(std::filesystem::exists(project.file("merged")));
    ASSERT_EQ(call(project, hazard + "--out second --shard 2/2").code, 0);
    const Outcome merged = call(project, "merge scenario.ini first second --out merged " + settings);
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_EQ(shell(project, "diff -r whole merged").code, 0);
}

TEST(Shards, OfAHazardMapDeleteNoPartsOfOthersAtWork) {
    const SampleProject project;
    add_blocks(project);
    // Another shard holds the lock while this one runs.
    const Outcome outcome = shell(project,
                                  "mkdir out\nflock -s out/.bannwald_hazard \"$bannwald\" run scenario.ini "
                                  "--quiet --shard 1/2 --overwrite --out out\n");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("other shards are at work"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace coupling::shards_test
