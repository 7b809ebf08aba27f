// What users get wrong in cases of their own.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/validation/forest_cases/case_runs.hpp"

namespace coupling::validation::forest_cases::slips_test {
namespace {

TEST(SlipInAForestCase, OfAColumnIsNamed) {
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

TEST(SlipInAForestCase, OfTheClimateIsNamed) {
    for (const std::string name : {"forest_old", "forest_demography"}) {
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

}  // namespace
}  // namespace coupling::validation::forest_cases::slips_test
