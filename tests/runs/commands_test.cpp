#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/runs/program.hpp"

namespace coupling::commands_test {
namespace {

TEST(Program, WritesAnExampleThatItCanRead) {
    const SampleProject project;
    const Outcome written = call(project, "init new --quiet");
    EXPECT_EQ(written.code, 0) << written.err;
    EXPECT_EQ(written.out, "new/scenario.ini\n");
    const Outcome checked = call(project, "check new/scenario.ini");
    EXPECT_EQ(checked.code, 0) << checked.err;
    for (const std::string word :
         {"rocks", "memory", "time", "53020 points", "valley road (artificial), house"}) {
        EXPECT_NE(checked.out.find(word), std::string::npos) << checked.out;
    }
    EXPECT_FALSE(std::filesystem::exists(project.file("new") / "out"));
}

TEST(Program, PrintsSettingsWithDefaultsAndSources) {
    const SampleProject project;
    const Outcome outcome = call(project, "check scenario.ini --print-settings --set rockfall.preset=strict");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("* release.diameter_m"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("* picus.jump_angle_scatter"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("Rammer et al. 2010"), std::string::npos);
}

TEST(Program, TakesEarlierNamesOfSettingsWithANote) {
    const SampleProject project;
    project.replace("scenario.ini", "[targets]", "[rockfall]\njump_angle_scatter = 0.1\n[targets]");
    const Outcome earlier = call(project,
                                 "run scenario.ini --set release.rocks=300 --set "
                                 "rockfall.lateral_slow_deg=5 --out earlier");
    EXPECT_EQ(earlier.code, 0) << earlier.err;
    const std::string note =
        "rockfall.jump_angle_scatter is renamed to picus.jump_angle_scatter; it works as "
        "before, but write the new name";
    EXPECT_NE(earlier.err.find(note), std::string::npos) << earlier.err;
    EXPECT_NE(earlier.err.find("--set rockfall.lateral_slow_deg=5: rockfall.lateral_slow_deg is renamed to "
                               "picus.lateral_slow_deg"),
              std::string::npos)
        << earlier.err;

    project.replace("scenario.ini", "[rockfall]\njump_angle", "[picus]\njump_angle");
    const Outcome now =
        shell(project,
              "\"$bannwald\" run scenario.ini --set release.rocks=300 --set "
              "picus.lateral_slow_deg=5 --out now && diff -r earlier/tables now/tables && diff "
              "-r earlier/rasters now/rasters");
    EXPECT_EQ(now.code, 0) << now.out << now.err;
    EXPECT_EQ(now.err.find("renamed"), std::string::npos) << now.err;

    const Outcome compared = call(project, "compare earlier now");
    EXPECT_EQ(compared.code, 0) << compared.err;
    EXPECT_EQ(compared.out.find("jump_angle_scatter"), std::string::npos) << compared.out;
}

TEST(Program, HelpsWithEverything) {
    const SampleProject project;
    const Outcome help = call(project, "--help");
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find("bannwald run SCENARIO"), std::string::npos);
    EXPECT_NE(help.out.find("75  interrupted"), std::string::npos);
    EXPECT_NE(call(project, "--help-all").out.find("contact_radius_m"), std::string::npos);
    const std::string section = call(project, "--help-all release").out;
    EXPECT_TRUE(section.starts_with("[release]\n")) << section;
    EXPECT_NE(section.find("\n  rocks  "), std::string::npos) << section;
    EXPECT_EQ(section.find("contact_radius_m"), std::string::npos);
    const std::string of_collapse = call(project, "--help-all collapse").out;
    EXPECT_TRUE(of_collapse.starts_with("[collapse]\n")) << of_collapse;
    EXPECT_NE(of_collapse.find("\n  hand_over  "), std::string::npos) << of_collapse;
    const std::string of_light = call(project, "--help-all light").out;
    EXPECT_NE(of_light.find("least_angle_deg"), std::string::npos) << of_light;
    EXPECT_NE(call(project, "--help-all [years]").out.find("states_every"), std::string::npos);
    EXPECT_NE(call(project, "--help-all").out.find("states_every"), std::string::npos);
    const Outcome unknown = call(project, "--help-all relaese");
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("'release'"), std::string::npos) << unknown.err;
    EXPECT_NE(call(project, "run --help").out.find("--overwrite"), std::string::npos);
    EXPECT_TRUE(call(project, "--version").out.starts_with("bannwald "));
}

TEST(Program, TellsWhatAFileHolds) {
    const SampleProject project;
    EXPECT_NE(call(project, "info dem.asc").out.find("12 x 10 cells of 10 m"), std::string::npos);
    EXPECT_NE(call(project, "info trees.csv").out.find("rows          3"), std::string::npos);
    EXPECT_EQ(call(project, "info gone.asc").code, 3);
}

TEST(Examples, OverYearsWarnOfTheLimitsOfTheirSurveyAlone) {
    const SampleProject project;
    for (const std::string example : {"regimes-small", "regimes"}) {
        ASSERT_EQ(call(project, "init " + example + " --quiet --example " + example).code, 0);
        const Outcome outcome = call(project, "check " + example + "/scenario.ini");
        EXPECT_EQ(outcome.code, 0);
        EXPECT_EQ(warnings_of_files(outcome), "") << example;
    }
}

TEST(Program, NamesTheFilesWorthOpening) {
    const SampleProject project;
    const Outcome some = call(project, "run scenario.ini --out some");
    ASSERT_EQ(some.code, 0) << some.err;
    EXPECT_NE(some.out.find("report.html"), std::string::npos) << some.out;
    EXPECT_NE(some.out.find("more files"), std::string::npos) << some.out;
    EXPECT_EQ(some.out.find("tables/runs.csv"), std::string::npos) << some.out;
    const Outcome all = call(project, "run scenario.ini --out all --verbose");
    EXPECT_NE(all.out.find("tables/runs.csv"), std::string::npos) << all.out;
    EXPECT_EQ(all.out.find("more files"), std::string::npos) << all.out;
    EXPECT_EQ(call(project, "run scenario.ini --out none --quiet").out, "");
}

}  // namespace
}  // namespace coupling::commands_test
