// Studies that get more years: each member goes on where the shorter run has left it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/coupling/assessments/decades/members/random_study.hpp"
#include "tests/runs/years.hpp"

namespace coupling::growing_years_test {
namespace {

namespace fs = std::filesystem;
using decades::RandomStudy;

std::string run(const std::vector<std::string>& settings) {
    std::string command = "run scenario.ini --quiet ";
    for (const std::string& setting : settings) {
        command += "--set \"" + setting + "\" ";
    }
    return command;
}

/// Two regimes with two replicates, rocks each second year, for so many years.
std::string study(int years) {
    return std::string{four_members} + "--set run.years=" + std::to_string(years) + " ";
}

class GrowingYears : public ::testing::Test {
protected:
    [[nodiscard]] int simulated(const std::string& out) const {
        const auto summary = nlohmann::json::parse(project_.read(out + "/summary.json"));
        return summary.at("run").at("simulated_member_years").get<int>();
    }
    void expect_done(const std::string& arguments) const {
        const Outcome outcome = call(project_, arguments);
        ASSERT_EQ(outcome.code, 0) << arguments << '\n' << outcome.err;
    }
    /// All files of the results but how much was simulated, and the sums over the file that says so.
    void expect_same(const std::string& one, const std::string& other) const {
        const Outcome outcome =
            shell(project_, "diff -r -x summary.json -x .checksums -x members " + one + " " + other +
                                " && grep -v simulated_member_years " + one + "/summary.json > one.json; " +
                                "grep -v simulated_member_years " + other +
                                "/summary.json > other.json; diff one.json other.json");
        EXPECT_EQ(outcome.code, 0) << outcome.out.substr(0, 2000);
    }

    ForestProject project_;
};

TEST_F(GrowingYears, GiveTheBytesOfARunMadeAtOnce) {
    decades::write_random_study_files(project_);
    for (std::uint32_t seed = 101; seed <= 108; ++seed) {
        const RandomStudy random = decades::random_study(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + random.in_words());
        const std::string out = "out" + std::to_string(seed);
        const auto members = static_cast<int>(random.members);
        expect_done(run(random.shorter()) + "--out " + out);
        EXPECT_EQ(simulated(out), members * random.first);
        expect_done(run(random.longer()) + "--overwrite --out " + out);
        EXPECT_EQ(simulated(out), members * (random.goes_on ? random.more : random.first + random.more));
        expect_done(run(random.longer()) + "--out at_once" + std::to_string(seed));
        expect_same(out, "at_once" + std::to_string(seed));
    }
}

TEST_F(GrowingYears, AreCountedByCheck) {
    expect_done(study(4) + "--out out");
    const std::string options = study(7).substr(study(7).find("--set"));
    const Outcome before = call(project_, "check scenario.ini " + options + "--out out");
    EXPECT_NE(before.out.find("4, of which an earlier run has left 4 in part in the folder of results; 4 to "
                              "simulate, 12 of 28 member-years"),
              std::string::npos)
        << before.out;
    const std::string more = options + "--set run.replicates=3 ";
    expect_done(study(7) + "--out out --overwrite");
    EXPECT_EQ(simulated("out"), 12);
    const Outcome after = call(project_, "check scenario.ini " + more + "--out out");
    EXPECT_NE(after.out.find("left 4 in the folder of results; 2 to simulate, 14 of 42 member-years"),
              std::string::npos)
        << after.out;
    // The shorter run is still there, and stays when one with other maps comes.
    expect_done(study(4) + "--out out --overwrite");
    EXPECT_EQ(simulated("out"), 0);
    expect_done(study(4) + "--set output.map_years=1 --out out --overwrite");
    EXPECT_EQ(simulated("out"), 16);
    expect_done(study(4) + "--out out --overwrite");
    EXPECT_EQ(simulated("out"), 0);
    expect_done(study(4) + "--set output.map_years=0 --out out --overwrite");
    EXPECT_EQ(simulated("out"), 0) << "fewer maps are among those";
}

TEST_F(GrowingYears, AreSimulatedAllAgainWhereAnInputChanged) {
    expect_done(study(4) + "--out out");
    project_.replace("records.csv", ",600,", ",601,");
    expect_done(study(5) + "--out out --overwrite");
    EXPECT_EQ(simulated("out"), 20);
    expect_done(study(5) + "--out at_once");
    expect_same("out", "at_once");
}

TEST_F(GrowingYears, BeginAnewWhereAKeptPartIsDamaged) {
    expect_done(study(4) + "--out out");
    for (const fs::directory_entry& entry : fs::directory_iterator{project_.file("out/members")}) {
        if (entry.path().filename().string().find("_4_") != std::string::npos) {
            // In the middle: what it says at its beginning stays.
            const std::string name = "out/members/" + entry.path().filename().string();
            std::string bytes = project_.read(name);
            bytes[bytes.size() / 2] ^= 1;
            project_.write(name, bytes);
            break;
        }
    }
    const Outcome outcome = call(project_, study(6) + "--out out --overwrite");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("is damaged: what it kept is simulated again"), std::string::npos);
    EXPECT_EQ(simulated("out"), 3 * 2 + 6);
    expect_done(study(6) + "--out at_once");
    expect_same("out", "at_once");
}

TEST_F(GrowingYears, GoOnAfterAnInterruptionAndFromShards) {
    expect_done(study(4) + "--out out");
    ASSERT_EQ(shell(project_, "cp -r out shards").code, 0);
    const std::string longer = study(30);
    const Outcome stopped =
        shell(project_, interrupted_once("out/parts/member_*", longer + "--threads 1 --out out --overwrite"));
    ASSERT_EQ(stopped.code, 75) << stopped.err;
    expect_done(longer + "--out out");
    EXPECT_EQ(simulated("out"), 4 * 26) << "those of both calls";
    expect_done(longer + "--out shards --overwrite --shard 1/2");
    expect_done(longer + "--out shards --shard 2/2");
    expect_done(longer + "--out shards");
    EXPECT_EQ(simulated("shards"), 4 * 26);
    expect_done(longer + "--out at_once");
    expect_same("out", "at_once");
    expect_same("shards", "at_once");
}

}  // namespace
}  // namespace coupling::growing_years_test
