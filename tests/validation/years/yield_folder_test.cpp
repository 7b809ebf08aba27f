// The folder forest_yield: stands against a yield table, as users copy it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "tests/validation/forest_cases/case_runs.hpp"
#include "validation/engine/tables.hpp"

namespace coupling::validation::yield_folder_test {
namespace {

using forest_cases::result_of;
using forest_cases::shipped;

/// The rows of sites.csv whose names these are, nothing judged.
CaseFiles folder_of(const std::vector<std::string>& sites) {
    CaseFiles files = shipped("forest_yield");
    std::istringstream rows{files.texts["sites.csv"]};
    std::string kept;
    for (std::string row; std::getline(rows, row);) {
        const std::string name = row.substr(0, row.find(','));
        if (name == "site" || std::find(sites.begin(), sites.end(), name) != sites.end()) {
            kept += row + "\n";
        }
    }
    files.texts["sites.csv"] = kept;
    files.texts["criteria.csv"] = "quantity,low,high,rests_on,rule,cause\n";
    return files;
}

/// So many years, lists of trees in each fifth, on a plot with so long sides.
CaseChanges years(int last, int side_m = 100, std::vector<std::string> more = {}) {
    CaseChanges changes;
    std::string lists;
    for (int year = 5; year <= last; year += 5) {
        lists += (lists.empty() ? "" : ", ") + std::to_string(year);
    }
    const std::string side = std::to_string(side_m);
    changes.overrides = {"years.seeds=1", "run.years=" + std::to_string(last),
                         "output.tree_list_years=" + lists, "terrain.plane_width_m=" + side,
                         "terrain.plane_length_m=" + side};
    changes.overrides.insert(changes.overrides.end(), more.begin(), more.end());
    return changes;
}

double value_of(const CaseResult& result, const std::string& figure) {
    return result.variants.front().values.at(figure).value;
}

bool warned(const CaseFiles& files, const std::string& sentence) {
    const std::vector<std::string> warnings = read_case(files, years(10, 30)).warnings;
    return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
        return warning.find(sentence) != std::string::npos;
    });
}

TEST(YieldFolder, ChangesNoLawOfARun) {
    EXPECT_FALSE(forest_cases::changes_a_law(read_case(folder_of({"piab_1000"}), years(10, 30))));
}

TEST(YieldFolder, StartsAsTheYoungestStandAndKeepsTheStemsOfTheTable) {
    const CaseResult result = result_of(folder_of({"piab_1000"}), years(30));
    for (const char* age : {"40", "50", "60"}) {
        EXPECT_NEAR(value_of(result, std::string{"stems_ratio:piab_1000:"} + age), 1.0, 0.01) << age;
    }
    // Guttenberg, class II, age 50.
    EXPECT_NEAR(value_of(result, "volume_m3pha:piab_1000:50") / value_of(result, "volume_ratio:piab_1000:50"),
                320.0, 1e-6);
    EXPECT_TRUE(std::isnan(value_of(result, "volume_ratio:piab_1000:140"))) << "not grown so long";
    EXPECT_FALSE(result.variants.front().values.contains("volume_ratio:piab_1000:30")) << "its start";
}

/// All species, one site each: three of four figures up to 100 years (the case asks for 85 % of all).
TEST(YieldFolder, MeetsTheTablesOfLightDemandingSpeciesToo) {
    // Larch and pine stood four times too dense and half as tall.
    const std::vector<std::string> sites{"piab_1000", "abal_500", "fasy_500", "lade_500",
                                         "pisy_1000", "frex_500", "bepe_500", "qupe_500"};
    const CaseResult result = result_of(folder_of(sites), years(80));
    for (const std::string& site : sites) {
        EXPECT_GE(value_of(result, "share_within:" + site.substr(0, 4) + ":to_100"), 0.75) << site;
        if (!site.starts_with("frex") && !site.starts_with("bepe")) {  // judged by no line of their own
            EXPECT_LE(value_of(result, "greatest_density:" + site), 1.1) << site;
        }
        EXPECT_GE(value_of(result, "twin_stems_pha:" + site + ":70"),
                  value_of(result, "stems_pha:" + site + ":70"))
            << site;
    }
}

TEST(YieldFolder, RanksElevations) {
    const CaseResult result =
        result_of(folder_of({"piab_500", "piab_1000", "piab_1750", "acps_500", "acps_1500"}), years(60, 50));
    const auto volume = [&](const std::string& site) {
        return value_of(result, "twin_volume_m3pha:" + site + ":70");
    };
    EXPECT_GT(volume("piab_500"), volume("piab_1000"));
    EXPECT_GT(volume("piab_1000"), volume("piab_1750"));
    EXPECT_GT(volume("acps_500"), volume("acps_1500"));
}

TEST(YieldFolder, SharesTheFiguresThatAgree) {
    const CaseResult result = result_of(folder_of({"piab_1000", "fasy_1500"}), years(30, 50));
    double agree = 0.0;
    for (const std::string figure : {"volume_ratio", "dbh_ratio", "height_ratio"}) {
        for (const std::string age : {"40", "50", "60"}) {
            agree += std::abs(value_of(result, figure + ":piab_1000:" + age) - 1.0) <= 0.15 ? 1.0 : 0.0;
        }
    }
    EXPECT_NEAR(value_of(result, "share_within:piab:to_100"), agree / 9.0, 1e-9);
    EXPECT_EQ(value_of(result, "share_within:all:to_100"), value_of(result, "share_within:piab:to_100"));
    EXPECT_FALSE(result.variants.front().values.contains("volume_ratio:fasy_1500:40")) << "it has no table";
    EXPECT_GT(value_of(result, "volume_m3pha:fasy_1500:40"), 0.0);
}

TEST(YieldFolder, GivesTheSameFiguresOnAnyNumberOfThreads) {
    const auto figures = [](int threads) {
        const CaseResult result = result_of(folder_of({"piab_1000", "abal_500"}), years(20, 50), threads);
        std::ostringstream out;
        write_table(out, "figures.csv", {&result, 1});
        write_table(out, "plots.csv", {&result, 1});
        return out.str();
    };
    EXPECT_EQ(figures(1), figures(3));
}

TEST(YieldFolder, GrowsTheSpeciesOfItsOwnFolder) {
    CaseFiles files = folder_of({"piab_1000"});
    files.texts["species.csv"] = std::string{config::shipped_table("species.csv")};
    const auto volume = [](const CaseFiles& of) {
        return value_of(result_of(of, years(20, 50)), "volume_m3pha:piab_1000:50");
    };
    const double as_shipped = volume(files);
    EXPECT_EQ(as_shipped, volume(folder_of({"piab_1000"})));
    std::string& text = files.texts["species.csv"];
    const std::size_t density = text.find(",430,400,", text.find("PIAB"));
    ASSERT_NE(density, std::string::npos);
    text.replace(density, 9, ",230,400,");
    EXPECT_GT(volume(files), 1.1 * as_shipped) << "light wood makes more volume of the same mass";
}

/// The site piab_1000 with a table of its own, stand 3.
CaseFiles own_table(const std::string& rows) {
    CaseFiles files = folder_of({"piab_1000"});
    files.texts["yield_tables.csv"] =
        "stand,table,class,age_years,mean_height_m,stems_pha,basal_area_m2pha,mean_dbh_cm,volume_m3pha\n" +
        rows;
    files.texts["starts.csv"] =
        "stand,species,stems_pha,mean_dbh_cm,mean_height_m,age_years\n3,piab,2400,15,13,35\n";
    return files;
}

TEST(YieldFolder, TakesAnyTable) {
    const CaseFiles files =
        own_table("3,my table,II.5,35,13,2400,,15,290\n3,my table,II.5,40,15,2000,,17,330\n");
    const CaseResult result = result_of(files, years(10, 50, {"output.tree_list_years=5"}));
    EXPECT_NEAR(value_of(result, "volume_m3pha:piab_1000:40") / value_of(result, "volume_ratio:piab_1000:40"),
                330.0, 1e-6);
    EXPECT_FALSE(result.variants.front().values.contains("volume_ratio:piab_1000:50"));
}

TEST(YieldFolder, DoubtsTablesThatNoStandCanHave) {
    const std::string first = "3,mine,II,35,13,2400,,15,290\n";
    EXPECT_FALSE(warned(own_table(first + "3,mine,II,60,20,1200,,22.5,470\n"), "yield_tables.csv"));
    EXPECT_TRUE(warned(own_table(first + "3,mine,II,60,24,1200,,22.5,470\n3,mine,II,80,30,750,,26,590\n"),
                       "mean_dbh_cm and mean_height_m are swapped"));
    EXPECT_TRUE(
        warned(own_table(first + "3,mine,II,60,20,470,,22.5,1200\n"),
               "yield_tables.csv, line 3: a volume that is less than 0.15 or more than 0.75 of basal"));
    EXPECT_TRUE(warned(own_table(first + "3,mine,II,60,20,2500,,22.5,970\n"),
                       "line 3: more stems than at the age before"));
    EXPECT_TRUE(warned(own_table(first + "3,mine,II,60,20,1200,30,22.5,470\n"),
                       "line 3: stems and mean diameter that make another basal area"));
    EXPECT_TRUE(warned(own_table(first + "3,mine,II,60,20,1200,,11,120\n"),
                       "line 3: a mean tree that is less than 15 or more than 150 times as high as thick"));
}

}  // namespace
}  // namespace coupling::validation::yield_folder_test
