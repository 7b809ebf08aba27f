#include "validation/engine/kinds/validation_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "tests/validation/case_texts.hpp"

namespace coupling::validation::validation_case_test {
namespace {

using testing::even_slope;

std::vector<config::Problem> problems_of(const CaseFiles& files, const CaseChanges& changes = {}) {
    try {
        read_case(files, changes);
    } catch (const config::InputError& error) {
        return error.problems();
    }
    return {};
}

bool any_at(const std::vector<config::Problem>& problems, const std::string& file, std::size_t line) {
    return std::any_of(problems.begin(), problems.end(), [&](const config::Problem& problem) {
        return problem.place.file == "cases/even/" + file && problem.place.line == line;
    });
}

TEST(ReadCase, TellsTheProblemsOfAllFilesAtOnce) {
    CaseFiles files = even_slope();
    files.texts["profile.csv"] = "length_m,slope_deg,surface\n-3,38,fine_debris\n";
    files.texts["sections.csv"] = "section,from_m,to_m\nA,100,50\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule\nmean_sped_mps,1,2,independent,x\n"
        "tree_hits_mean,3,2,perhaps,x\n";
    files.texts["observed.csv"] = "quantity,value\nmean_speed_mps,1\n";
    files.texts["variants.csv"] =
        "variant,preset,overrides,meaning\nx,strikt,,\ny,strict,rockfall.nothing=1,\n";
    files.texts["choices.csv"] = "choice,overrides,reason\nz,terrain.cell_m=-1,\n";
    const auto problems = problems_of(files);
    EXPECT_TRUE(any_at(problems, "profile.csv", 2));
    EXPECT_TRUE(any_at(problems, "sections.csv", 2));
    EXPECT_TRUE(any_at(problems, "criteria.csv", 2));
    EXPECT_TRUE(any_at(problems, "criteria.csv", 3));
    EXPECT_TRUE(any_at(problems, "observed.csv", 0));  // a column is missing: the whole file
    EXPECT_TRUE(any_at(problems, "variants.csv", 2));
    EXPECT_TRUE(any_at(problems, "variants.csv", 3));
    EXPECT_TRUE(any_at(problems, "choices.csv", 2));
    for (const config::Problem& problem : problems) {
        EXPECT_FALSE(problem.found.empty());
    }
}

TEST(ReadCase, SuggestsTheNearestFigure) {
    CaseFiles files = even_slope();
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule\nreaching_share:fot,0,1,independent,x\n";
    const auto problems = problems_of(files);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].expected, "'reaching_share:foot'");
}

TEST(ReadCase, RefusesFiguresOfTreesOnlyWhereTheyNeedAStand) {
    CaseFiles files = even_slope();
    files.texts["observed.csv"] = "quantity,value,source\nreduction.mean_speed_mps,0.2,x\n";
    EXPECT_EQ(problems_of(files).size(), 1U);
    files.texts["case.ini"] += testing::stand_of_site_2;
    EXPECT_TRUE(problems_of(files).empty());
    EXPECT_TRUE(read_case(files).needs_open());
}

TEST(ReadCase, ReadsPublishedFiguresOfBothEnsembles) {
    CaseFiles files = even_slope();
    files.texts["published.csv"] =
        "quantity,value,deviation,series,source\n"
        "mean_speed_mps,9.6,1.5,100x100,Table 3\n"
        "mean_speed_mps,9.4,,10000,Table 3\n"
        "run_out_mean_m,453,9,10000,between rocks\n";
    const ValidationCase of = read_case(files);
    const PublishedFigure& speed = of.published.at("mean_speed_mps");
    EXPECT_EQ(speed.value, 9.4);
    EXPECT_EQ(speed.series_mean, 9.6);
    EXPECT_EQ(speed.deviation, 1.5);
    EXPECT_EQ(of.published.at("run_out_mean_m").deviation, 9.0);
}

TEST(ReadCase, PutsStrictAndDefaultFirst) {
    CaseFiles files = even_slope();
    files.texts["variants.csv"] =
        "variant,preset,overrides,meaning\n"
        "initial,paper_initial,,the initial model\n"
        "default,default,terrain.cell_m=5,coarser\n";
    const ValidationCase of = read_case(files);
    ASSERT_EQ(of.variants.size(), 3U);
    EXPECT_EQ(of.variants[0].name, "strict");
    EXPECT_EQ(of.variants[1].meaning, "coarser");
    EXPECT_EQ(of.recipe(of.variants[1].preset, of.variants[1].overrides)->cell_m, 5.0);
    EXPECT_EQ(of.variants[2].preset, "paper_initial");
}

TEST(ReadCase, TakesTheChangesOfTheUserBelowThoseOfVariantsAndChoices) {
    CaseFiles files = even_slope();
    files.texts["variants.csv"] = "variant,preset,overrides,meaning\nx,strict,terrain.cell_m=5,\n";
    files.texts["steep.csv"] = "length_m,slope_deg,surface\n300,45,fine_debris\n";
    files.texts["choices.csv"] =
        "choice,overrides,reason\nother,terrain.profile=steep.csv,x\n"
        "cells,terrain.cell_m=5,x\n";
    CaseChanges changes;
    changes.overrides = {"terrain.cell_m=4"};
    changes.most_rocks = 20;
    changes.profile_file = "surveyed.csv";
    changes.profile_text = "distance_m,height_m,surface\n0,200,road\n290,0,road\n";
    const ValidationCase of = read_case(files, changes);
    const auto recipe = of.recipe("strict", of.variants[2].overrides);
    EXPECT_EQ(recipe->cell_m, 5.0);  // x is what its name says
    EXPECT_EQ(of.recipe("strict", {})->cell_m, 4.0);
    EXPECT_EQ(recipe->rocks, 20U);
    EXPECT_LE(recipe->series * recipe->rocks_per_series, 20U);
    EXPECT_EQ(of.profile(*recipe).front().height_m, 200.0);
    ASSERT_EQ(of.choices.size(), 1U);  // the other profile is no choice any more
    EXPECT_EQ(of.notes.size(), 2U);
}

TEST(ReadCase, ReadsTheProfileThatAChoiceNames) {
    CaseFiles files = even_slope();
    files.texts["steep.csv"] = "length_m,slope_deg,surface\n300,45,fine_debris\n";
    files.texts["choices.csv"] =
        "choice,overrides,reason\nother,terrain.profile=steep.csv,x\n"
        "none,terrain.profile=missing.csv,x\n";
    const auto problems = problems_of(files);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_TRUE(any_at(problems, "choices.csv", 3));
}

TEST(ReadRecipe, TellsWhatSettingsGetWrongTogether) {
    const auto first_line = [](const std::string& kind, const std::string& more) {
        const auto problems = problems_of(even_slope(kind, more));
        return problems.empty() ? std::string{} : problems.front().found;
    };
    EXPECT_EQ(first_line("profile", testing::stand_of_site_2), "a stand on a profile");
    EXPECT_EQ(first_line("slope", "[stand]\nstems_per_ha = 290\nto_m = 10\n"), "no species");
    EXPECT_EQ(first_line("slope", "[stand]\nstems_per_ha = 290\nto_m = 10\nspecies = ABAX:1\n"),
              "species 'ABAX'");
    EXPECT_EQ(
        first_line("slope", "[stand]\nstems_per_ha = 5000\nspacing_m = 4\nto_m = 10\nspecies = ABAL:1\n"),
        "stand.spacing_m 4 for 5000 stems/ha");
    EXPECT_NE(first_line("slope", "[factors]\nx = 1\n"), "");
}

TEST(ShippedCases, CanAllBeRead) {
    for (const CaseFiles& files : shipped_cases()) {
        EXPECT_NO_THROW({
            const ValidationCase of = read_case(files);
            EXPECT_TRUE(files.has("README.md")) << files.name;
        }) << files.name;
    }
}

/// Settings of the forest that say what a case is about; all others are laws.
const std::set<std::string> of_the_subject = {"disturbance.wind", "disturbance.snow", "disturbance.beetle",
                                              "disturbance.first_year", "forest.browsing_pressure"};

TEST(ShippedCases, RunTheLawsOfTheForestThatARunHas) {
    // What is validated is what users run: a case may switch disturbances and deer, and nothing else.
    int judged = 0;
    for (const CaseFiles& files : shipped_cases()) {
        const ValidationCase of = read_case(files);
        for (const std::string& note : of.notes) {
            static const std::string start = "not the defaults of a run: ";
            if (!note.starts_with(start)) {
                continue;
            }
            ++judged;
            std::istringstream settings{note.substr(start.size())};
            for (std::string setting; std::getline(settings >> std::ws, setting, ',');) {
                EXPECT_TRUE(of_the_subject.contains(setting.substr(0, setting.find(' '))))
                    << files.name << ": " << setting;
            }
        }
    }
    EXPECT_GT(judged, 0) << "cases with disturbances say so";
}

}  // namespace
}  // namespace coupling::validation::validation_case_test
