#include "coupling/exchange/regimes/rows.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "coupling/exchange/regimes/columns.hpp"
#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::rows_test {
namespace {

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
