// What users get wrong in cases of their own.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/validation/forest_cases/case_runs.hpp"
#include "tests/validation/forest_cases/remeasured/synthetic_plot.hpp"

namespace coupling::validation::forest_cases::slips_test {
namespace {

TEST(SlipInAForestCase, OfAFileNameIsNamed) {
    CaseFiles files = remeasured::synthetic_case();
    EXPECT_TRUE(read_case(files).warnings.empty());
    files.texts["sapling.csv"] = "species,stems_pha,height_m\npiab,500,1\n";
    files.texts["notes.txt"] = "measured in the rain\n";
    ASSERT_EQ(read_case(files).warnings.size(), 1U);
    EXPECT_EQ(read_case(files).warnings[0],
              "synthetic/sapling.csv is not read; if it is 'saplings.csv', give it that name; keep it if it "
              "is your own");
    for (const CaseFiles& shipped_case : shipped_cases()) {
        for (const std::string& warning : read_case(shipped_case).warnings) {
            EXPECT_EQ(warning.find(" is not read; "), std::string::npos) << warning;
        }
    }
}

TEST(SlipInAForestCase, OfAColumnIsNamedInEachKind) {
    struct Slip {
        std::string name;
        std::string table;
        std::string column;
        std::string misspelt;
    };
    for (const Slip& slip : {Slip{"forest_yield", "sites.csv", "nitrogen_kg_ha_yr", "nitrogen_kg_ha"},
                             Slip{"forest_yield", "yield_tables.csv", "basal_area_m2pha", "basal_area_m2"}}) {
        CaseFiles files = shipped(slip.name);
        const std::size_t head = files.texts[slip.table].find("\n" + slip.table.substr(0, 4)) + 1;
        const std::size_t at = files.texts[slip.table].find(slip.column, head);
        ASSERT_NE(at, std::string::npos) << slip.table;
        files.texts[slip.table].replace(at, slip.column.size(), slip.misspelt);
        const std::vector<std::string> warnings = read_case(files).warnings;
        ASSERT_EQ(warnings.size(), 1U) << slip.name;
        EXPECT_NE(warnings[0].find("column '" + slip.misspelt + "' is not read; if it is '" + slip.column),
                  std::string::npos)
            << warnings[0];
    }
    CaseFiles files = shipped("forest_demography");
    replace(files.texts["reference.csv"], "\nspecies,place,", "\nspecies,remarks,place,");
    std::string& text = files.texts["reference.csv"];
    for (std::size_t at = text.find('\n', text.find("\nspecies") + 1); at + 1 < text.size();
         at = text.find('\n', at + 1)) {
        text.insert(text.find(',', at) + 1, ",");
    }
    // Rain far from that of the series is doubted, too.
    const std::vector<std::string> warnings = read_case(files).warnings;
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [](const std::string& warning) {
                                return warning.find("column 'remarks' is not read") != std::string::npos;
                            }),
              1);
}

TEST(SlipInAForestCase, OfTheClimateIsNamedInEachKind) {
    for (const std::string name : {"forest_yield", "forest_old", "forest_demography"}) {
        CaseFiles files = shipped(name);
        replace(files.texts["climate.csv"], ",frost_days,", ",frost_day,");
        const std::vector<std::string> warnings = read_case(files).warnings;
        EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
            return warning.find("'frost_day' is not read") != std::string::npos;
        })) << name;
    }
}

bool warned(const CaseFiles& files, const std::string& sentence) {
    const std::vector<std::string> warnings = read_case(files).warnings;
    return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
        return warning.find(sentence) != std::string::npos;
    });
}

/// A case of one site of spruce with a table of its own.
CaseFiles own_yield(const std::string& rows, const std::string& site = "a,piab,1000,0.8,mine,II") {
    CaseFiles files = shipped("forest_yield");
    files.texts["sites.csv"] = "site,species,elevation_m,fertility,table,class\n" + site + "\n";
    files.texts["yield_tables.csv"] =
        "table,class,age_years,mean_height_m,stems_pha,mean_dbh_cm,volume_m3pha\n" + rows;
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule,cause\n";
    replace(files.texts["case.ini"], "ages_years = 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140", "");
    replace(files.texts["case.ini"], "drawn_ages_years = 70, 100", "");
    return files;
}

TEST(SlipInAForestCase, OfYieldTablesIsDoubted) {
    const std::string good =
        "mine,II,40,13,2400,15,290\nmine,II,60,20,1200,22.5,470\nmine,II,80,25,750,29,590\n";
    EXPECT_FALSE(warned(own_yield(good), "yield_tables.csv"));
    EXPECT_TRUE(warned(own_yield("mine,II,40,15,2400,13,290\nmine,II,60,22.5,1200,20,470\n"
                                 "mine,II,80,29,750,25,590\n"),
                       "mean_dbh_cm and mean_height_m are swapped"));
    EXPECT_TRUE(warned(own_yield("mine,II,40,13,290,15,2400\nmine,II,60,20,470,22.5,1200\n"),
                       "yield_tables.csv, line 2: 2 rows with a volume that is less than 0.15 or more than "
                       "0.75 of basal area times height"));
    EXPECT_TRUE(warned(own_yield("mine,II,40,13,1200,15,140\nmine,II,60,20,1300,22.5,470\n"),
                       "line 3: 1 row with more stems than at the age before"));
    CaseFiles contradicting = own_yield(good);
    replace(contradicting.texts["yield_tables.csv"], "volume_m3pha\n", "volume_m3pha,basal_area_m2pha\n");
    replace(contradicting.texts["yield_tables.csv"], ",290\n", ",290,42.4\n");
    replace(contradicting.texts["yield_tables.csv"], ",470\n", ",470,30\n");
    replace(contradicting.texts["yield_tables.csv"], ",590\n", ",590,49.5\n");
    EXPECT_TRUE(warned(contradicting, "line 3: 1 row with stems and mean diameter that make another basal"));
}

TEST(SlipInAForestCase, OfATableOrClassNamesThoseThatThereAre) {
    const std::string rows = "mine,II,40,13,2400,15,290\nmine,II,60,20,1200,22.5,470\n";
    EXPECT_EQ(problem_of(own_yield(rows)), "");
    EXPECT_NE(
        problem_of(own_yield(rows, "a,piab,1000,0.8,mien,II")).find("found table 'mien', expected one of"),
        std::string::npos);
    EXPECT_NE(problem_of(own_yield(rows, "a,piab,1000,0.8,mine,III"))
                  .find("found class 'III' of table 'mine', expected one of validation/forest_yield/"
                        "yield_tables.csv: 'II'"),
              std::string::npos);
    EXPECT_NE(problem_of(own_yield(rows, "a,piab,1000,0.8,mine,II\na,piab,1200,0.8,mine,II"))
                  .find("sites.csv:3:1: found site 'a' a second time, as in line 2"),
              std::string::npos);
}

TEST(SlipInAForestCase, OfCrownsAndRadiationIsDoubted) {
    EXPECT_FALSE(warned(shipped("forest_light"), "check"));
    CaseFiles files = shipped("forest_light");
    replace(files.texts["trees.csv"], "crown_base_m,crown_radius_m", "crown_radius_m,crown_base_m");
    EXPECT_TRUE(warned(files, "trees.csv: crowns that cover the plot "));
    files = shipped("forest_light");
    files.texts["radiation.csv"] = "month,global_mjpm2,diffuse_share\n";
    for (int month = 1; month <= 12; ++month) {
        files.texts["radiation.csv"] += std::to_string(month) + ",12,0.5\n";
    }
    EXPECT_TRUE(warned(files, "radiation.csv: 144 MJ/m2 in a year"));
}

TEST(SlipInAForestCase, OfTheLatitudeIsDoubted) {
    CaseFiles files = shipped("forest_light");
    std::string& slopes = files.texts["slopes.csv"];
    for (std::size_t at = slopes.find(",46."); at != std::string::npos; at = slopes.find(",46.", at + 1)) {
        slopes.replace(at, 4, ",4.6");
    }
    EXPECT_TRUE(warned(files, "; the species are trees of Europe")) << slopes;
}

TEST(SlipInAForestCase, OfTheLatitudeIsRefusedWithYieldTables) {
    CaseFiles files = shipped("forest_yield");
    files.texts["sites.csv"] =
        "site,species,elevation_m,fertility,table,class,latitude_deg\n"
        "piab_1000,piab,1000,0.8,guttenberg_1915,2,47\n";
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nvolume_ratio:piab_1000:50,0.5,2,fitted,,\n";
    EXPECT_EQ(problem_of(files), "");
    replace(files.texts["sites.csv"], ",2,47", ",2,-47");
    EXPECT_NE(problem_of(files).find(
                  "sites.csv:2:43: found latitude_deg -47, expected a place north of the equator"),
              std::string::npos)
        << problem_of(files);
}

}  // namespace
}  // namespace coupling::validation::forest_cases::slips_test
