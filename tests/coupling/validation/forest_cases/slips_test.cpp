// What users get wrong in cases of their own.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/coupling/validation/forest_cases/case_runs.hpp"
#include "tests/coupling/validation/forest_cases/remeasured/synthetic_plot.hpp"

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
                             Slip{"forest_yield", "yield_tables.csv", "basal_area_m2pha", "basal_area_m2"},
                             Slip{"forest_dry", "sites.csv", "rain_factor", "rain_faktor"}}) {
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
    ASSERT_EQ(read_case(files).warnings.size(), 1U);
    EXPECT_NE(read_case(files).warnings[0].find("column 'remarks' is not read"), std::string::npos);
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
