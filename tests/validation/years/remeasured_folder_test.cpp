// The folder forest_hauersteig: a plot whose trees were measured twice, as users copy it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <utility>

#include "config/text/numbers.hpp"
#include "tests/validation/forest_cases/case_runs.hpp"

namespace coupling::validation::remeasured_folder_test {
namespace {

using forest_cases::problem_of;
using forest_cases::replace;
using forest_cases::result_of;
using forest_cases::shipped;

double dbh_cm(int number) {
    return 12.0 + (number * 11) % 36;
}
const char* species_of(int number) {
    return number % 2 == 0 ? "piab" : "fasy";
}

/// A plot that nobody measured: spruces and beeches five metres apart, 12 to 47 cm thick, numbers 1 to 36.
/// Ten years later each tree is 2 cm thicker, numbers 3 and 4 are dead, 6 is felled, a fir of 7.5 cm is new.
CaseFiles plot_of_1980() {
    CaseFiles files = shipped("forest_hauersteig");
    std::ostringstream first;
    std::ostringstream last;
    first << "tree_id,x_m,y_m,species,dbh_cm\n";
    last << "tree_id,species,dbh_cm\n";
    for (int number = 1; number <= 36; ++number) {
        first << number << ',' << 2.5 + 5.0 * ((number - 1) % 6) << ',' << 2.5 + 5.0 * ((number - 1) / 6)
              << ',' << species_of(number) << ',' << dbh_cm(number) << '\n';
        if (number != 3 && number != 4 && number != 6) {
            last << number << ',' << species_of(number) << ',' << dbh_cm(number) + 2.0 << '\n';
        }
    }
    last << "101,abal,7.5\n102,abal,6.5\n";
    files.texts["measured_first.csv"] = first.str();
    files.texts["measured_last.csv"] = last.str();
    files.texts["felled.csv"] = "tree_id,year\n6,1985\n";
    files.texts["sites.csv"] = "site,words,least_dbh_cm,ingrowth\nplot,my plot,7,yes\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nincrement_ratio:all:all,0.2,5,independent,,\n";
    return files;
}

CaseChanges ten_years(int replicates = 1) {
    CaseChanges changes;
    changes.overrides = {"run.first_year=1981",
                         "run.years=10",
                         "terrain.plane_width_m=30",
                         "terrain.plane_length_m=30",
                         "years.seeds=1",
                         "climate.sequence=random",
                         "run.replicates=" + std::to_string(replicates)};
    return changes;
}

double value_of(const CaseResult& result, const std::string& figure) {
    return result.variants.front().values.at(figure).value;
}

std::vector<std::string> warnings_of(const CaseFiles& files) {
    std::vector<std::string> warnings = read_case(files, ten_years()).warnings;
    std::erase_if(warnings,
                  [](const std::string& one) { return one.find("measured_last.csv") == std::string::npos; });
    return warnings;
}

TEST(RemeasuredFolder, ChangesNoLawOfARun) {
    EXPECT_FALSE(forest_cases::changes_a_law(read_case(shipped("forest_hauersteig"))));
}

TEST(RemeasuredFolder, ObservesGrowthDeathsAndIngrowth) {
    const ValidationCase of = read_case(plot_of_1980(), ten_years());
    const auto observed = [&](const std::string& name) { return of.published.at(name).value.value_or(-1.0); };
    EXPECT_NEAR(observed("increment_cm:all:all"), 0.2, 1e-9);
    EXPECT_NEAR(observed("increment_cm:piab:20cm"), 0.2, 1e-9);
    EXPECT_NEAR(observed("survivors:all:all"), 33.0 / 35.0, 1e-9) << "the felled one does not count";
    EXPECT_NEAR(observed("survivors:fasy:all"), 17.0 / 18.0, 1e-9);
    EXPECT_NEAR(observed("survivors:piab:all"), 16.0 / 17.0, 1e-9);
    EXPECT_NEAR(observed("ingrowth_pha:abal"), 1.0 / 0.09, 1e-6) << "one is too thin to count";
    EXPECT_NEAR(observed("stems_pha:all"), 34.0 / 0.09, 1e-6);
}

TEST(RemeasuredFolder, GivesEachFigureThatItNames) {
    const CaseResult result = result_of(plot_of_1980(), ten_years(2));
    const CaseResult again = result_of(plot_of_1980(), ten_years(2), 1);
    for (const auto& [name, measured] : result.variants.front().values) {
        const double other = value_of(again, name);
        EXPECT_TRUE(measured.value == other || (std::isnan(measured.value) && std::isnan(other)))
            << "any number of threads: " << name << " " << measured.value << " " << other;
    }
    EXPECT_GT(value_of(result, "increment_cm:all:all"), 0.02);
    EXPECT_LT(value_of(result, "increment_cm:all:all"), 1.5);
    EXPECT_GT(value_of(result, "survivors:all:all"), 0.5);
    EXPECT_TRUE(std::isfinite(value_of(result, "thickest_dbh_ratio:all")));
}

TEST(RemeasuredFolder, AgreesWithAPlotThatTheModelGrewItself) {
    CaseFiles files = plot_of_1980();
    files.texts["figures.sql"] +=
        "-- table own\nSELECT CAST(tree_id AS INTEGER), species, dbh_cm FROM trees, asked WHERE year = "
        "last_year;\n";
    const CaseResult grown = result_of(files, ten_years());
    const auto own = std::find_if(grown.tables.begin(), grown.tables.end(),
                                  [](const PlainTable& table) { return table.caption == "own"; });
    ASSERT_NE(own, grown.tables.end());
    std::string last = "tree_id,species,dbh_cm\n";
    for (const std::vector<std::string>& row : own->rows) {
        EXPECT_NE(row[0], "6") << "felled";
        last += row[0] + "," + row[1] + "," + row[2] + "\n";
    }
    files.texts["measured_last.csv"] = last;
    const CaseResult result = result_of(files, ten_years());
    EXPECT_NEAR(value_of(result, "increment_ratio:all:all"), 1.0, 1e-9);
    EXPECT_NEAR(value_of(result, "increment_ratio:piab:all"), 1.0, 1e-9);
    EXPECT_NEAR(value_of(result, "dbh_rmse_cm:all:all"), 0.0, 1e-9);
    EXPECT_NEAR(value_of(result, "survivors_difference:all:all"), 0.0, 1e-9);
    EXPECT_NEAR(value_of(result, "ingrowth_difference_pha:all"), 0.0, 1e-6);
    EXPECT_NEAR(value_of(result, "basal_area_ratio:all"), 1.0, 1e-9);
    EXPECT_NEAR(value_of(result, "thickest_dbh_ratio:all"), 1.0, 1e-9);
}

TEST(RemeasuredFolder, KeepsTheTreesThatAYearlyChanceOfDeathMustLeave) {
    CaseFiles files = plot_of_1980();
    for (const auto& [file, dbh] : {std::pair{"measured_first.csv", "15\n"}, {"measured_last.csv", "17\n"}}) {
        // Thin trees fall on no others.
        files.texts[file] = std::regex_replace(files.texts[file], std::regex{"[.0-9]+\n"}, dbh);
    }
    // One in a hundred is alive at 600 years, spruces as beeches.
    const double left = std::pow(0.01, 10.0 / 600.0);
    constexpr int replicates = 50;
    CaseChanges changes = ten_years(replicates);
    changes.overrides.insert(changes.overrides.end(),
                             {"forest.age_deaths=gap_model", "forest.stress_deaths=no",
                              "forest.drought_death=0", "forest.self_thinning=no", "forest.regeneration=no"});
    const double four_sigma = 4.0 * std::sqrt(left * (1.0 - left) / (35.0 * replicates));
    EXPECT_NEAR(value_of(result_of(files, changes), "survivors:all:all"), left, four_sigma);
}

TEST(RemeasuredFolder, TakesSaplingsThatGrowIn) {
    CaseFiles files = plot_of_1980();
    replace(files.texts["sites.csv"], ",7,yes", ",1,yes");
    const double without = value_of(result_of(files, ten_years()), "ingrowth_pha:all");
    files.texts["saplings.csv"] = "stand,species,stems_pha,height_m,age_years\nall,fasy,5000,1.9,12\n";
    CaseChanges changes = ten_years();
    changes.overrides.emplace_back("stands.saplings=saplings.csv");
    EXPECT_GT(value_of(result_of(files, changes), "ingrowth_pha:all"), without + 200.0);
}

TEST(RemeasuredFolder, LeavesIngrowthOutThatNobodyCounted) {
    CaseFiles files = plot_of_1980();
    replace(files.texts["sites.csv"], ",7,yes", ",7,no");
    std::string& last = files.texts["measured_last.csv"];
    last.erase(last.find("101,"));
    const CaseResult result = result_of(files, ten_years());
    EXPECT_FALSE(result.variants.front().values.contains("ingrowth_pha:all"));
    EXPECT_LE(value_of(result, "stems_pha:all"), 35.0 / 0.09);
}

TEST(RemeasuredFolder, NotesHowMissingHeightsAreFilledIn) {
    const std::vector<std::string> notes = read_case(plot_of_1980(), ten_years()).notes;
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
        return note.find("measured_first.csv: ") != std::string::npos &&
               note.find("height") != std::string::npos;
    }));
}

TEST(RemeasuredFolder, WarnsOfGrowthThatCanHardlyBe) {
    EXPECT_TRUE(warnings_of(plot_of_1980()).empty()) << warnings_of(plot_of_1980()).front();
    CaseFiles files = plot_of_1980();
    replace(files.texts["measured_last.csv"], "\n1,fasy,25", "\n1,fasy,53.1");
    replace(files.texts["measured_last.csv"], "\n2,piab,36", "\n2,piab,33.4");
    const std::vector<std::string> warnings = warnings_of(files);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings[0].find("measured_last.csv, line 2: more than 3 cm of diameter growth a year; correct "
                               "tree_id or dbh_cm, or leave the tree out of both tables"),
              std::string::npos)
        << warnings[0];
    EXPECT_NE(warnings[1].find("line 3: a diameter that shrinks by more than 0.5 cm, the error of a tape"),
              std::string::npos)
        << warnings[1];
    replace(files.texts["measured_last.csv"], "\n2,piab,33.4", "\n2,piab,33.6");
    EXPECT_EQ(warnings_of(files).size(), 1U);
    files = plot_of_1980();
    replace(files.texts["measured_last.csv"], "\n1,fasy,25", "\n1001,fasy,25");
    ASSERT_EQ(warnings_of(files).size(), 1U);
    EXPECT_NE(
        warnings_of(files)[0].find("line 2: counted as ingrowth, but thicker than least_dbh_cm and 1 cm "
                                   "a year; correct tree_id"),
        std::string::npos)
        << warnings_of(files)[0];
}

TEST(RemeasuredFolder, TakesAPlotWhoseTreesAllDied) {
    CaseFiles files = plot_of_1980();
    files.texts.erase("criteria.csv");
    files.texts["measured_last.csv"] = "tree_id,species,dbh_cm\n101,piab,7.5\n102,fasy,8\n";
    EXPECT_EQ(problem_of(files, ten_years()), "") << "young ones grew in";
}

TEST(RemeasuredFolder, NamesAFileThatIsNotRead) {
    CaseFiles files = plot_of_1980();
    files.texts["sapling.csv"] = "species,stems_pha,height_m\npiab,500,1\n";
    files.texts["notes.txt"] = "measured in the rain\n";
    const std::vector<std::string> warnings = read_case(files, ten_years()).warnings;
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [](const std::string& warning) {
                                return warning.find(" is not read; ") != std::string::npos;
                            }),
              1);
    for (const CaseFiles& shipped_case : shipped_cases()) {
        for (const std::string& warning : read_case(shipped_case).warnings) {
            EXPECT_EQ(warning.find(" is not read; "), std::string::npos) << warning;
        }
    }
}

}  // namespace
}  // namespace coupling::validation::remeasured_folder_test
