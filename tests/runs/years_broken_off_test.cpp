#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::years_broken_off_test {
namespace {

namespace fs = std::filesystem;

/// Four members of so many years that a run can be broken off.
const std::string long_members = std::string{four_members} + "--set run.years=60 ";

TEST(Years, GoOnAfterTheRunWasKilledAgainAndAgain) {
    // Killed when so many parts are there: once while rocks fall over the bare slope, then twice between
    // members, each time on another number of threads.
    const ForestProject project;
    ASSERT_EQ(call(project, long_members + "--out whole").code, 0);
    const std::string script =
        "parts() { ls out/parts/$1_*.part 2>/dev/null | wc -l; }\n"
        "kill_with() {\n"
        "  \"$bannwald\" " +
        long_members +
        "--threads $3 --out out &\n"
        "  while kill -0 $! 2>/dev/null && [ $(parts $1) -lt $2 ]; do :; done\n"
        "  kill -KILL $!; wait $!\n"
        "  [ $? -eq 137 ] && [ ! -e out/summary.json ] && [ $(parts $1) -ge $2 ]\n"
        "}\n"
        "kill_with bare 1 1 || exit 1\n"
        "kill_with member 1 3 || exit 2\n"
        "before=$(parts member)\n"
        "kill_with member $((before + 1)) 1 || exit 3\n"
        "\"$bannwald\" " +
        long_members +
        "--threads 2 --out out || exit 4\n"
        "diff -r whole out\n";
    const Outcome outcome = shell(project, script);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

const std::string interrupted_after_a_member = interrupted_once("out/parts/member_*.part", long_members);

TEST(Years, KeepFinishedMembersWhenInterrupted) {
    const ForestProject project;
    const Outcome interrupted = shell(project, interrupted_after_a_member);
    ASSERT_EQ(interrupted.code, 75) << interrupted.err;
    EXPECT_NE(interrupted.err.find("bannwald: interrupted; the finished parts are kept, run the same "
                                   "command again to go on"),
              std::string::npos)
        << interrupted.err;
    std::string name;
    for (const fs::directory_entry& entry : fs::directory_iterator{project.file("out/parts")}) {
        if (entry.path().filename().string().starts_with("member_") && entry.path().extension() == ".part") {
            name = entry.path().filename().string();
        }
    }
    ASSERT_NE(name, "");
    EXPECT_FALSE(fs::exists(project.file("out/summary.json")));

    const Outcome other = call(project, long_members + "--seed 2");
    EXPECT_EQ(other.code, 2) << other.err;
    EXPECT_NE(other.err.find("parts of a run with other settings"), std::string::npos) << other.err;

    const std::string part = project.read("out/parts/" + name);
    project.write("out/parts/" + name, part.substr(0, part.size() / 2));
    const Outcome cut_off = call(project, long_members);
    EXPECT_EQ(cut_off.code, 3) << cut_off.err;
    EXPECT_NE(cut_off.err.find(name + ": found the part file is cut off or damaged"), std::string::npos)
        << cut_off.err;
    EXPECT_FALSE(fs::exists(project.file("out/summary.json")));

    project.write("out/parts/" + name, part);
    EXPECT_EQ(call(project, long_members).code, 0);
    EXPECT_FALSE(fs::exists(project.file("out/parts")));
}

TEST(Years, LeaveNothingWhenInterruptedBeforeAMemberIsThrough) {
    const ForestProject project;
    const Outcome outcome =
        shell(project, interrupted_once("out",
                                        "run scenario.ini --quiet --set run.years=1000 "
                                        "--set climate.sequence=repeat --set release.rocks=100000"));
    EXPECT_EQ(outcome.code, 75) << outcome.err;
    EXPECT_NE(outcome.err.find("no part was finished"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(project.file("out")));
}

}  // namespace
}  // namespace coupling::years_broken_off_test
