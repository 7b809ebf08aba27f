#include "coupling/exchange/regimes/rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "coupling/exchange/regimes/columns.hpp"
#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::rows_test {
namespace {

std::string problems_in(const std::string& text) {
    config::Problems problems;
    read_interventions(table_of(text), species_table(), problems);
    std::string all;
    for (const config::Problem& problem : problems.list()) {
        all += config::to_string(problem) + '\n';
    }
    return all;
}

std::vector<Intervention> rows_of(const std::string& text) {
    config::Problems problems;
    std::vector<Intervention> rows = read_interventions(table_of(text), species_table(), problems);
    problems.throw_if_any();
    return rows;
}

TEST(ReadInterventions, TakesWhatIsThereAndKeepsDefaultsElsewhere) {
    const auto rows = rows_of(
        "treatment;first_year;every_years;last_year;where;entries;length_m;width_m;angle_deg;left_share;"
        "log_angle_deg;anchored;stump_height_m;note\n"
        "clear_cut;5;20;85;slits;4;60;15;-45;0.2;65;no;1.2;anything\n");
    ASSERT_EQ(rows.size(), 1U);
    const Intervention& row = rows[0];
    EXPECT_EQ(row.name, "clear_cut");
    EXPECT_EQ(row.treatment, Treatment::clear_cut);
    EXPECT_EQ(row.first_year, 5);
    EXPECT_EQ(row.every_years, 20);
    EXPECT_EQ(row.last_year, 85);
    EXPECT_EQ(row.ground.where, Where::slits);
    EXPECT_EQ(row.ground.entries, 4);
    EXPECT_EQ(row.ground.length_m, 60.0);
    EXPECT_EQ(row.ground.angle_deg, -45.0);
    EXPECT_EQ(row.ground.gap_m, Ground{}.gap_m);
    EXPECT_EQ(row.felling.left_share, 0.2);
    EXPECT_NEAR(row.felling.to_fall_line.in_degrees(), 65.0, 1e-9);
    EXPECT_FALSE(row.felling.anchored);
    EXPECT_EQ(row.felling.stump_height_m, 1.2);
    EXPECT_EQ(row.place.line, 2U);
}

TEST(ReadInterventions, ReadsSpeciesByCodeOrLatinName) {
    const auto rows =
        rows_of("treatment,species,plants_pha\nplant,piab abal,1500 500\nplant_clusters,Abies alba,\n");
    EXPECT_EQ(rows.at(0).species, (std::vector{species_of("piab"), species_of("abal")}));
    EXPECT_EQ(rows.at(0).plants_pha, (std::vector{1500.0, 500.0}));
    EXPECT_EQ(rows.at(1).species, std::vector{species_of("abal")});
    EXPECT_EQ(rows_of("treatment,share,species\ntend,0.5,\"Abies alba, lade\"\n").at(0).species,
              (std::vector{species_of("abal"), species_of("lade")}));
}

TEST(ReadInterventions, GivesFollowersTheGroundOfTheirRow) {
    const auto rows = rows_of(
        "name,treatment,every_years,after,after_years,where,entries,width_m,angle_deg,share\n"
        "opening,shelter_cut,10,,,strips,3,30,0,0.4\n"
        "clearance,clear_cut,,opening,10,,,,,\n");
    EXPECT_EQ(rows.at(1).ground, rows.at(0).ground);
    EXPECT_EQ(rows.at(1).after_years, 10);
}

TEST(ReadInterventions, NamesEveryProblemWithItsLine) {
    const std::string text = problems_in(
        "treatment,share,where,width_m,angle_deg,target_density,species,plants_pha,colour\n"
        "thin_bellow,0.2,,,,,,,\n"            // line 2
        "thin_below,1.2,,,,,,,\n"             // 3
        "thin_below,,,,,,,,\n"                // 4
        "thin_density,0.3,,,,0.6,,,\n"        // 5
        "clear_cut,,strips,,0,,,,\n"          // 6
        "clear_cut,,,30,,,,,\n"               // 7
        "plant,,,,,,pica,2000,\n"             // 8
        "plant,,,,,,piab abal,2000,\n"        // 9
        "slit_cut,,,,,,,,\n"                  // 10
        "clear_cut,,everywhere,,,,,,\n"       // 11
        "clear_cut,,strips,5e-324,0,,,,\n");  // 12, strips without number
    for (const std::string expected :
         {"column 'colour'",
          "regime.csv:2:1: found treatment 'thin_bellow', expected 'thin_below'",
          "regime.csv:3:",
          "share = '1.2', expected a number in (0, 1]",
          "regime.csv:4:",
          "no share",
          "regime.csv:5:",
          "share = '0.3', expected no value here: thin_density has no column share",
          "regime.csv:6:",
          "no width_m",
          "regime.csv:7:",
          "width_m = '30', expected no value here: where = all has no column width_m, it belongs to strips, "
          "slits, "
          "corridors",
          "regime.csv:8:",
          "species 'pica'",
          "regime.csv:9:",
          "1 numbers for 2 species",
          "regime.csv:10:",
          "'clear_cut' with where = slits",
          "regime.csv:11:",
          "where 'everywhere', expected one of all, stands, strips, slits, polygons",
          "regime.csv:12:",
          "width_m = '5e-324', expected a number in [1, 1000]"}) {
        EXPECT_NE(text.find(expected), std::string::npos) << expected << "\nnot in\n" << text;
    }
}

TEST(ReadInterventions, TellsAProblemOnce) {
    const std::string text = problems_in(
        "name,treatment,after,after_years,share,species,plants_pha\n"
        "open,shelter_cut,,,1.4,,\nclear,clear_cut,open,10,,,\nyoung,plant,clear,5,,piab,many\n");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
    EXPECT_NE(text.find("share = '1.4'"), std::string::npos) << text;
    EXPECT_NE(text.find("plants_pha = 'many'"), std::string::npos) << text;
}

TEST(ReadInterventions, RefusesFieldsThatContradictEachOther) {
    const auto refused = [](const std::string& header, const std::string& row, const std::string& expected) {
        const std::string text = problems_in(header + '\n' + row + '\n');
        EXPECT_NE(text.find(expected), std::string::npos) << row << "\n" << text;
    };
    refused("treatment,first_year,last_year", "clear_cut,20,10",
            "last_year 10, expected first_year (20) or later");
    refused("treatment,from_age_years,to_age_years", "clear_cut,60,40", "to_age_years 40");
    refused("treatment,where,width_m,angle_deg,entries", "clear_cut,strips,30,0,4",
            "4 entries without every_years");
    refused("treatment,where", "clear_cut,cuts_of", "cuts_of:ROW with the name of a row above it");
    refused("treatment,where", "clear_cut,cuts_of:group",
            "where 'cuts_of:group', expected the name of a row");
    refused("treatment,share,oldest_years,where", "salvage,0.5,2,\nfence,,,cuts_of:salvage",
            "salvage is a salvage, expected a row above it that cuts trees");
    refused("name,treatment,where,stands", "a,group_cut,,\nb,fence,cuts_of:a,2",
            "cuts_of has no column stands");
    refused("name,treatment,where,after", "a,group_cut,,\nb,clear_cut,stands,\nc,fence,cuts_of:a,b",
            "expected after = a, or a row that acts on the same cuts");
    refused("name,treatment,where,after", "a,clear_cut,,\nb,fence,stands,a",
            "where = 'stands', expected nothing");
    refused("treatment,where", "clear_cut,corridors", "a value for lines");
    refused("treatment", "thin_to_basal_area", "a value for to_basal_area_m2pha");
    refused("treatment,only_species,spare_species", "clear_cut,piab abal,abal", "expected one of the two");
    refused("treatment,from_slope_deg,to_slope_deg", "clear_cut,40,30", "at most to_slope_deg (30)");
    refused("treatment,retain_pha", "clear_cut,-5", "retain_pha = '-5'");
    refused("treatment,after_years", "clear_cut,5", "after_years without `after`");
    refused("treatment,after", "clear_cut,opening", "after 'opening'");
    refused("treatment,share", "tend,0.5", "tending without favoured species");
    refused("treatment,share", "tend,0.5", "without favoured species");
    refused("treatment", "target_diameter", "target_diameter without from_dbh_cm");
    refused("treatment,species,spacing_m", "plant_clusters,piab,15", "a multiple of 10 m");
    refused("treatment,name", "clear_cut,a\nclear_cut,a", "a second row with the name 'a'");
    refused("treatment,share,species,from_height_m,to_height_m", "tend,0.5,abal,4,2", "from_height_m 4");
}

TEST(RegimeColumns, AreAllInTheTheoryChapter) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/coupling/exchange/regimes/README.md"};
    const std::string text{std::istreambuf_iterator<char>{in}, {}};
    for (const RegimeColumn& column : regime_columns()) {
        const std::string row = "| `" + std::string{column.name} + "` | " + users_text(column) + " | " +
                                default_text(column) + " | " + std::string{column.meaning} + " | " +
                                std::string{column.rules.source} + " |\n";
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
    for (std::size_t i = 0; i < treatment_count; ++i) {
        EXPECT_NE(text.find("| `" + name_of(static_cast<Treatment>(i)) + "` |"), std::string::npos)
            << name_of(static_cast<Treatment>(i));
    }
}

}  // namespace
}  // namespace coupling::rows_test
