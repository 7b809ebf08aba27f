// Runs over years in several climates.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/runs/years.hpp"

namespace coupling::climates_test {
namespace {

/// Two regimes, two climates, two replicates.
const std::string climates = std::string{four_members} + "--set climate.variants=climates.csv ";
const std::string members = climates + "--set run.years=2 ";

void add_climates(const ForestProject& project) {
    project.write("climates.csv",
                  "name,temperature_change_k,precipitation_change\npresent,0,1\nwarm,4,0.6\n");
}

/// Lines of a table in which the field of a column is `value`, and its head.
std::string rows_with(const std::string& text, const std::string& value) {
    std::istringstream in{text};
    std::string kept;
    for (std::string line; std::getline(in, line);) {
        if (kept.empty() || line.find("," + value + ",") != std::string::npos) {
            kept += line + "\n";
        }
    }
    return kept;
}

TEST(Climates, LeaveTheFirstOneAsItIsAlone) {
    const ForestProject project;
    add_climates(project);
    ASSERT_EQ(call(project, members + "--out both").code, 0);
    project.write("climates.csv", "name,temperature_change_k,precipitation_change\npresent,0,1\n");
    ASSERT_EQ(call(project, members + "--out alone").code, 0);
    for (const std::string name : {"stands", "dbh_classes", "forest_years", "mortality", "trees_0", "trees_2",
                                   "protection", "targets", "runs", "causes", "gaps", "target_profile",
                                   "regimes_by_year", "regimes_worst_year", "regime_differences"}) {
        const std::string path = "/tables/" + name + ".csv";
        const std::string alone = project.read("alone" + path);
        EXPECT_EQ(rows_with(project.read("both" + path), "present"), alone) << name;
        EXPECT_EQ(rows_with(alone, "present"), alone) << name;
        EXPECT_NE(project.read("both" + path).find(",warm,"), std::string::npos) << name;
    }
    EXPECT_EQ(
        shell(project, "diff -r -x '*.qml' both/rasters/rockfall/bare alone/rasters/rockfall/bare").code, 0);
    for (const std::string part : {"forest/none", "rockfall/single_tree_selection"}) {
        // Colours span all maps of a run, so that styles differ.
        EXPECT_EQ(
            shell(project, "diff -r -x '*.qml' both/rasters/" + part + "/present alone/rasters/" + part).code,
            0)
            << part;
    }
}

TEST(Climates, AreComparedByReplicateUnderTheSameRegime) {
    const ForestProject project;
    add_climates(project);
    ASSERT_EQ(call(project, members).code, 0);
    // Basal area of each member in the last year.
    std::map<std::string, std::map<std::string, std::vector<double>>> m2pha;
    const config::Table stands = table(project, "out/tables/stands.csv");
    for (std::size_t row = 0; row < stands.rows(); ++row) {
        if (stands.text(row, "stand") == "all" && stands.text(row, "species") == "all" &&
            stands.text(row, "year") == "2") {
            m2pha[stands.text(row, "regime")][stands.text(row, "climate")].push_back(
                number(stands, row, "basal_area_m2pha"));
        }
    }
    const config::Table differences = table(project, "out/tables/climate_differences.csv");
    std::size_t checked = 0;
    for (std::size_t row = 0; row < differences.rows(); ++row) {
        EXPECT_EQ(differences.text(row, "climate"), "warm");
        EXPECT_EQ(differences.text(row, "reference"), "present");
        if (differences.text(row, "quantity") == "basal_area_m2pha" && differences.text(row, "year") == "2") {
            const auto& of_regime = m2pha.at(differences.text(row, "regime"));
            const auto& [here, there] = std::pair{of_regime.at("warm"), of_regime.at("present")};
            ASSERT_EQ(here.size(), 2U);
            EXPECT_NE(here[0], there[0]) << "the climate does something";
            EXPECT_NEAR(number(differences, row, "mean_difference"),
                        0.5 * (here[0] - there[0] + here[1] - there[1]), 2e-3);
            ++checked;
        }
    }
    EXPECT_EQ(checked, 2U) << "one for each regime";
    // What falls over the bare slope knows no climate.
    const config::Table runs = table(project, "out/tables/targets.csv");
    std::map<std::string, std::string> bare;
    for (std::size_t row = 0; row < runs.rows(); ++row) {
        if (runs.text(row, "cover") == "bare") {
            const std::string key = runs.text(row, "replicate") + "/" + runs.text(row, "year") + "/" +
                                    runs.text(row, "target_id");
            const auto [found, is_new] = bare.emplace(key, runs.text(row, "share_percent"));
            EXPECT_EQ(found->second, runs.text(row, "share_percent")) << key;
        }
    }
}

TEST(Climates, GiveTheSameBytesInShardsAndThreads) {
    const ForestProject project;
    add_climates(project);
    ASSERT_EQ(call(project, members + "--threads 1 --out whole").code, 0);
    for (const std::string shard : {"1/3", "2/3", "3/3"}) {
        ASSERT_EQ(
            call(project, members + "--threads 2 --out part_" + shard.substr(0, 1) + " --shard " + shard)
                .code,
            0);
    }
    std::string words = members.substr(members.find(' ') + 1);
    words.insert(words.find("scenario.ini") + 12, " part_1 part_2 part_3 --out out");
    const Outcome merged = call(project, "merge " + words);
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_EQ(shell(project, "diff -r whole out").code, 0);
}

TEST(Climates, GoOnAfterAKill) {
    const ForestProject project;
    add_climates(project);
    const std::string longer = climates + "--set run.years=40 ";
    ASSERT_EQ(call(project, longer + "--out whole").code, 0);
    const Outcome outcome =
        shell(project, "\"$bannwald\" " + longer +
                           "--threads 1 --out out &\n"
                           "while kill -0 $! 2>/dev/null && ! ls out/parts/member_1_2_*.part "
                           ">/dev/null 2>&1; do :; done\n"
                           "kill -KILL $!; wait $!\n[ $? -eq 137 ] || exit 1\n"
                           "ls out/parts/member_1_1_1.part || exit 2\n\"$bannwald\" " +
                           longer + "--threads 2 --out out || exit 3\ndiff -r whole out\n");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Climates, AreToldByCheckAndComparedBetweenRuns) {
    const ForestProject project;
    add_climates(project);
    std::string words = members.substr(members.find(' '));
    words.erase(words.find(" --quiet"), 8);
    const Outcome check = call(project, "check" + words);
    ASSERT_EQ(check.code, 0) << check.err;
    for (const std::string line :
         {"members       2 regimes x 2 climates x 2 replicates, 2001 to 2002\n",
          "climate       present: 2001", "climate       warm: 2001", "climates      climates.csv, "}) {
        EXPECT_NE(check.out.find(line), std::string::npos) << line << check.out;
    }
    ASSERT_EQ(call(project, members + "--out a").code, 0);
    ASSERT_EQ(call(project, members + "--out b --set rockfall.preset=strict").code, 0);
    const Outcome compared = call(project, "compare a b --out c");
    ASSERT_EQ(compared.code, 0) << compared.err;
    EXPECT_NE(compared.out.find("regime none, climate warm"), std::string::npos) << compared.out;
    const config::Table rows = table(project, "c/compare.csv");
    std::size_t pairs = 0;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        pairs += rows.text(row, "run") == "B" && rows.text(row, "climate") == "warm" &&
                         !rows.text(row, "difference").empty()
                     ? 1
                     : 0;
    }
    EXPECT_GT(pairs, 5U);
}

}  // namespace
}  // namespace coupling::climates_test
