#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/coupling/inputs/forest_project.hpp"
#include "tests/runs/years.hpp"

namespace coupling::years_input_test {
namespace {

/// What is wrong with a project whose forest grows, and what the program has to say about it.
struct BadYears {
    std::string name;
    void (*spoil)(const SampleProject&);
    int code;
    std::string message;         ///< part of what goes to stderr
    std::string arguments = "";  ///< after `run scenario.ini`
};

void PrintTo(const BadYears& bad, std::ostream* out) {
    *out << bad.name;
}

void as_it_is(const SampleProject&) {}

const BadYears bad_years[] = {
    {"ClimateThatEndsBeforeTheRun", as_it_is, 4,
     "bannwald: climate.csv: found years 2001 to 2008, but none for 2009, expected all years of the run, "
     "2001 "
     "to 2010, or climate.sequence = repeat or random",
     "--set run.years=10"},
    {"ClimateWithoutAMonth",
     [](const SampleProject& p) {
         const std::string text = p.read("climate.csv");
         const std::size_t at = text.find("2003,5,");
         p.write("climate.csv", text.substr(0, at) + text.substr(text.find('\n', at) + 1));
     },
     4, "bannwald: climate.csv: found no month 5 of 2003, expected twelve months in each year"},
    {"RadiationInWatts",
     [](const SampleProject& p) {
         std::string text = "year,month,tmin_c,tmax_c,prec_mm,rad_mj_m2_d\n";
         for (int month = 1; month <= 48; ++month) {
             text += std::to_string(2001 + (month - 1) / 12) + ',' + std::to_string((month - 1) % 12 + 1) +
                     ",2,12,100,140\n";
         }
         p.write("climate.csv", text);
     },
     4, "expected MJ/m2 a day; this looks like W/m2 (times 0.0864)"},
    {"StandWithoutARecord",
     [](const SampleProject& p) { p.replace("records.csv", "8,FASY,400,20,,,,plenter\n", ""); }, 4,
     "bannwald: records.csv: found no record of stand 8, expected one for each stand of the map; stems_pha 0 "
     "where there are no trees",
     "--set trees.file= --set stands.records=records.csv"},
    {"UnknownSpecies", [](const SampleProject& p) { p.replace("trees.csv", "piab", "piax"); }, 4,
     "bannwald: trees.csv:3:13: found species 'piax', expected a code or Latin name of the species table "
     "(PIAB?)"},
    {"NoLatitude", [](const SampleProject& p) { p.replace("scenario.ini", "latitude_deg = 47\n", ""); }, 2,
     "bannwald: scenario.ini: found run.years above 0 without forest.latitude_deg, expected a number in [0, "
     "75] deg"},
    {"UnknownSpeciesOfTheRegion",
     [](const SampleProject& p) {
         p.replace("scenario.ini", "latitude_deg", "region_species = PIAB, ABAX\nlatitude_deg");
     },
     2,
     "bannwald: scenario.ini:16:18: found species 'ABAX', expected a code or Latin name of the species table "
     "(ABAL?)"},
    {"BrokenTreesThatFall", as_it_is, 2,
     "found tree_impact.remove_broken beside run.years 4, expected no: trees stand while the rocks of a year "
     "fall",
     "--set tree_impact.remove_broken=yes"},
    {"UnknownRegime", as_it_is, 2,
     "found regime 'pmf1', expected one of bau_shelterwood, none, pfm1, pfm2, single_tree_selection, or the "
     "name of a CSV file",
     "--set \"regimes.list=none, pmf1\""},
    {"RegimeOfAnUnknownTreatment",
     [](const SampleProject& p) { p.write("mine.csv", "name,treatment,first_year\ncut,clearcut,0\n"); }, 4,
     "bannwald: mine.csv:2:5: found treatment 'clearcut', expected 'clear_cut'",
     "--set \"regimes.list=none, mine.csv\""},
    {"RegimesOfOneName",
     [](const SampleProject& p) {
         std::filesystem::create_directory(p.file("sub"));
         p.write("sub/none.csv", "treatment\n");
     },
     2, "found regime 'sub/none.csv', expected regimes of different names",
     "--set \"regimes.list=none, sub/none.csv\""},
    {"RegimeFileThatIsNotThere", as_it_is, 3,
     "found regimes.list, which names no file: 'gone.csv', expected a file", "--set regimes.list=gone.csv"},
};

class ProgramOverYears : public ::testing::TestWithParam<BadYears> {};

TEST_P(ProgramOverYears, TellsWhatIsWrongAndLeavesNothingBehind) {
    const ForestProject project;
    GetParam().spoil(project);
    for (const std::string command : {"run", "check"}) {
        const Outcome outcome = call(project, command + " scenario.ini " + GetParam().arguments);
        EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
        EXPECT_NE(outcome.err.find(GetParam().message), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "") << command;
        EXPECT_FALSE(std::filesystem::exists(project.file("out")));
    }
}

INSTANTIATE_TEST_SUITE_P(BadYears, ProgramOverYears, ::testing::ValuesIn(bad_years),
                         [](const ::testing::TestParamInfo<BadYears>& bad) { return bad.param.name; });

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
          "rocks         20 a year, in 5 years of each member", "memory        up to ",
          "time          about "}) {
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

TEST(YearsInput, TellsSettingsThatOnlyTodayHeeds) {
    const ForestProject project;
    const Outcome quiet = call(project, "check scenario.ini");
    EXPECT_EQ(quiet.err.find("have no effect"), std::string::npos) << quiet.err;
    const Outcome told =
        call(project, "check scenario.ini --set output.percentiles=yes --set output.sample_paths=10");
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_NE(told.err.find("output.percentiles, output.sample_paths have no effect"), std::string::npos)
        << told.err;
}

TEST(YearsInput, ListsTheCodesWhereNoNameIsNear) {
    const ForestProject project;
    const Outcome far = call(project, "check scenario.ini --set forest.region_species=QQQQ");
    EXPECT_EQ(far.code, 2);
    EXPECT_NE(far.err.find("codes: PIAB, ABAL, FASY, "), std::string::npos) << far.err;
    const Outcome near = call(project, "check scenario.ini --set forest.region_species=PIAN");
    EXPECT_NE(near.err.find("(PIAB?)"), std::string::npos) << near.err;
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
