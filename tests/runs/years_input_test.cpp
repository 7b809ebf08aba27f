#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/coupling/inputs/forest_project.hpp"
#include "tests/runs/years.hpp"

namespace coupling::years_input_test {
namespace {

TEST(ProgramOverYearsWithDoubts, TellsThemAndKeepsThemInTheSummary) {
    const ForestProject project;
    project.write("trees.csv",
                  project.read("trees.csv") + "4,1060,2050,PIAB,20,15\n5,1025,2050,PIAB,20,15\n");
    const Outcome outcome = call(project, "run scenario.ini --set run.years=1");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string message :
         {"warning: trees.csv: 1 tree on the same spot as another",
          "note: trees.csv: 1 tree outside the forest: obstacles that do not grow"}) {
        EXPECT_NE(outcome.err.find("bannwald: " + message), std::string::npos) << outcome.err;
        const std::string sentence = message.substr(message.find(' ') + 1);
        EXPECT_NE(project.read("out/summary.json").find(sentence), std::string::npos) << sentence;
    }
}

TEST(CheckOverYears, TellsTheForestAndWhatTheRunTakes) {
    const ForestProject project;
    project.write("mine.csv", "name,treatment,first_year\ncut,clear_cut,0\n");
    const Outcome outcome =
        call(project,
             "check scenario.ini --threads 2 --set trees.file= --set stands.records=records.csv "
             "--set \"regimes.list=none, mine.csv\" --set run.replicates=3");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string line :
         {"forest        0.80 ha (80 patches of 10 m), ", "mean slope 35 degrees", "stands        2\n",
          "soil          2 types with 70 to 120 mm of water\n", "climate       2001 to 2008, its own years; ",
          "regimes       none (0 interventions), mine (1 intervention)\n",
          "members       2 regimes x 1 climate x 3 replicates, 2001 to 2004\n", "regime        mine.csv, ",
          "rocks         20 a year, in 5 years of each member", "memory        up to ", "time          "}) {
        EXPECT_NE(outcome.out.find(line), std::string::npos) << line << "\n---\n" << outcome.out;
    }
    EXPECT_EQ(outcome.out.find("bare slope is assessed"), std::string::npos) << outcome.out;
    EXPECT_FALSE(std::filesystem::exists(project.file("out")));
}

TEST(CheckOverYears, TellsHowTheForestBegins) {
    const ForestProject project;
    // Diameters of 32.5, 20 and 41 cm: 0.246 m2 of basal area on 0.8 ha.
    const Outcome listed = call(project, "check scenario.ini");
    EXPECT_NE(listed.out.find("trees         3 of the list, 3 species: 4 stems/ha, 0.3 m2/ha, "),
              std::string::npos)
        << listed.out;
    const Outcome bare = call(project, "check scenario.ini --set trees.file=");
    EXPECT_NE(bare.out.find("trees         bare ground\n"), std::string::npos) << bare.out;
}

TEST(CheckOverYears, NeedsNoRocks) {
    const SampleProject project;
    ASSERT_EQ(call(project, "init example --example forest --quiet").code, 0);
    const Outcome outcome = call(project, "check example/scenario.ini");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string line : {"trees         108 of the list, ", "rocks         none fall",
                                   "years drawn by chance; ", "regimes       none (0 interventions)\n"}) {
        EXPECT_NE(outcome.out.find(line), std::string::npos) << line << "\n---\n" << outcome.out;
    }
    EXPECT_EQ(outcome.out.find("sources"), std::string::npos) << outcome.out;
}

TEST(Examples, OverYearsAreWhole) {
    const SampleProject project;
    for (const std::string name : {"regimes-small", "regimes"}) {
        ASSERT_EQ(call(project, "init " + name + " --quiet --example " + name).code, 0);
        const Outcome outcome = call(project, "check " + name + "/scenario.ini");
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(outcome.out.find("pfm1 (1 intervention)"), std::string::npos) << outcome.out;
    }
}

TEST(YearsInput, WritesSpeciesAsTablesDo) {
    const ForestProject project;
    ASSERT_EQ(
        call(project, std::string{four_members} + "--set run.years=1 --set run.rockfall_every=0 --out out")
            .code,
        0);
    const config::Table stands = table(project, "out/tables/stands.csv");
    std::set<std::string> species;
    for (std::size_t row = 0; row < stands.rows(); ++row) {
        species.insert(stands.text(row, "species"));
    }
    EXPECT_TRUE(species.contains("PIAB") && !species.contains("piab"));
}

}  // namespace
}  // namespace coupling::years_input_test
