// Studies that get more regimes, climates and replicates.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/runs/years.hpp"

namespace coupling::growing_test {
namespace {

namespace fs = std::filesystem;

/// A study of `regimes` in the climates of a file, with so many replicates.
std::string study(const std::string& regimes, const std::string& climates, int replicates) {
    return "scenario.ini --set trees.file= --set stands.records=records.csv --set climate.sequence=random "
           "--set release.rocks=100 --set run.rockfall_every=2 --set run.years=3 --set \"regimes.list=" +
           regimes + "\" --set climate.variants=" + climates +
           " --set run.replicates=" + std::to_string(replicates) + " ";
}

std::string run(const std::string& study_and_options) {
    return "run --quiet " + study_and_options;
}

class GrowingStudies : public ::testing::Test {
protected:
    GrowingStudies() {
        project_.write("one.csv", "name,temperature_change_k,precipitation_change\nwarm,4,0.6\n");
        project_.write("two.csv",
                       "name,temperature_change_k,precipitation_change\nwarm,4,0.6\npresent,0,1\n");
    }

    [[nodiscard]] nlohmann::json size_of(const std::string& out) const {
        return nlohmann::json::parse(project_.read(out + "/summary.json")).at("run");
    }
    void expect_simulated(const std::string& out, int years, int of_years) const {
        EXPECT_EQ(size_of(out).at("simulated_member_years"), years);
        EXPECT_EQ(size_of(out).at("member_years"), of_years);
    }
    /// All files but how much was simulated.
    void expect_same(const std::string& one, const std::string& other) const {
        const Outcome outcome =
            shell(project_, "diff -r -x summary.json -x .checksums -x members " + one + " " + other +
                                " && grep -v simulated_member_years " + one + "/summary.json > one.json; " +
                                "grep -v simulated_member_years " + other +
                                "/summary.json > other.json; diff one.json other.json");
        EXPECT_EQ(outcome.code, 0) << outcome.out;
    }

    ForestProject project_;
};

TEST_F(GrowingStudies, SimulateOnlyWhatIsNewAndGiveTheBytesOfAFreshRun) {
    ASSERT_EQ(call(project_, run(study("none", "one.csv", 2) + "--out out")).code, 0);
    expect_simulated("out", 6, 6);
    // Another regime, before the known one; more replicates; another climate, after the known one.
    const std::string larger = study("single_tree_selection, none", "two.csv", 3);
    const Outcome refused = call(project_, run(larger + "--out out"));
    EXPECT_EQ(refused.code, 2);
    const Outcome check = call(project_, "check " + larger + "--out out");
    EXPECT_NE(
        check.out.find("12, of which an earlier run has left 2 in the folder of results; 10 to simulate"),
        std::string::npos)
        << check.out;
    ASSERT_EQ(call(project_, run(larger + "--out out --overwrite")).code, 0);
    expect_simulated("out", 30, 36);
    ASSERT_EQ(call(project_, run(larger + "--out fresh")).code, 0);
    expect_simulated("fresh", 36, 36);
    expect_same("fresh", "out");
    EXPECT_EQ(shell(project_, "ls fresh/members > a\nls out/members > b\ndiff a b").code, 0);
}

TEST_F(GrowingStudies, TakeNothingThatOtherSettingsOrInputsMade) {
    const std::string same = study("none", "one.csv", 1);
    const auto simulated_after = [&](const std::string& change) {
        EXPECT_EQ(call(project_, run(same + "--out out --overwrite")).code, 0);
        EXPECT_EQ(call(project_, run(same + "--out out --overwrite " + change)).code, 0);
        return size_of("out").at("simulated_member_years").get<int>();
    };
    for (const std::string change :
         {"--seed 7", "--set release.rocks=99", "--set run.years=4", "--set disturbance.wind=yes",
          "--set climate.temperature_change_k=1 --set climate.variants=", "--set forest.latitude_deg=45"}) {
        fs::remove_all(project_.file("out"));
        EXPECT_GT(simulated_after(change), 0) << change;
    }
    // What is asked of the result, and how it is written, concerns no member.
    for (const std::string change : {"--set decision.protection_at_least=55", "--set output.geopackage=no"}) {
        fs::remove_all(project_.file("out"));
        EXPECT_EQ(simulated_after(change), 0) << change;
    }
    fs::remove_all(project_.file("out"));
    ASSERT_EQ(call(project_, run(same + "--out out")).code, 0);
    project_.replace("dem.asc", "400 ", "401 ");
    ASSERT_EQ(call(project_, run(same + "--out out --overwrite")).code, 0);
    expect_simulated("out", 3, 3);
}

TEST_F(GrowingStudies, CountWhatThisRunSimulatedAlsoWhenSettingsComeBack) {
    const std::string same = study("none", "one.csv", 1);
    ASSERT_EQ(call(project_, run(same + "--out out")).code, 0);
    ASSERT_EQ(call(project_, run(same + "--seed 2 --out out --overwrite")).code, 0);
    expect_simulated("out", 3, 3);
    ASSERT_EQ(call(project_, run(same + "--out out --overwrite")).code, 0);
    expect_simulated("out", 0, 3);
}

TEST_F(GrowingStudies, RefusePartsOfAnotherBuildBeforeAnyWork) {
    const std::string same = run(study("none", "one.csv", 2));
    // The same program with other bytes: as after a change of its laws.
    const Outcome outcome =
        shell(project_,
              "cp \"$bannwald\" other && printf x >> other\n"
              "./other " +
                  same + "--out out --shard 1/2 || exit 1\n\"$bannwald\" " + same +
                  "--out out --shard 2/2 || exit 2\n\"$bannwald\" " + same + "--out out\n");
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("a part made by another build of the program"), std::string::npos)
        << outcome.err;
    ASSERT_EQ(call(project_, same + "--out out --overwrite").code, 0);
}

TEST_F(GrowingStudies, SimulateAgainWhatADamagedOrDeletedMemberKept) {
    const std::string same = study("none", "one.csv", 1);
    ASSERT_EQ(call(project_, run(same + "--out whole")).code, 0);
    ASSERT_EQ(call(project_, run(same + "--out out")).code, 0);
    for (const fs::directory_entry& entry : fs::directory_iterator{project_.file("out/members")}) {
        fs::resize_file(entry.path(), fs::file_size(entry.path()) - 1);
    }
    const Outcome damaged = call(project_, run(same + "--out out --overwrite"));
    EXPECT_EQ(damaged.code, 0) << damaged.err;
    EXPECT_NE(damaged.err.find("is damaged: what it kept is simulated again"), std::string::npos)
        << damaged.err;
    EXPECT_EQ(shell(project_, "diff -r whole out").code, 0);
    fs::remove_all(project_.file("out/members"));
    ASSERT_EQ(call(project_, run(same + "--out out --overwrite")).code, 0);
    EXPECT_EQ(shell(project_, "diff -r whole out").code, 0);
}

}  // namespace
}  // namespace coupling::growing_test
