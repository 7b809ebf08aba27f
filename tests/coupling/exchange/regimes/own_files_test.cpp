// The regimes that foresters asked for, as files (tests/runs/regime_study): valid, and refused with one clear
// error for one wrong value each.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "tests/coupling/exchange/regimes/regime_forest.hpp"

namespace coupling::own_files_test {
namespace {

std::string text_of(const std::string& file) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/tests/runs/regime_study/" + file};
    return {std::istreambuf_iterator<char>{in}, {}};
}

/// Two lines of a cable crane in place of those of the study, which lie elsewhere.
std::vector<config::Shape> crane_lines(const std::string& file, config::Shape::Kind kind) {
    if (file == "cable_lines.csv" && kind == config::Shape::Kind::line) {
        return {{config::Shape::Kind::line, {{{40.0, 0.0}, {40.0, 120.0}}}},
                {config::Shape::Kind::line, {{{90.0, 0.0}, {90.0, 120.0}}}}};
    }
    config::fail(config::ExitCode::file, {file}, "not there");
}

/// Two stands, the eastern one steep.
forest::PatchGrid slope_with_steep_part() {
    const forest::PatchGrid even = two_stands(14);
    std::vector<forest::Patch> patches = even.patches();
    for (forest::Patch& patch : patches) {
        if (patch.management_unit == 2) {
            patch.slope = config::Angle::from_degrees(45.0);
        }
    }
    return {even.frame(), patches};
}

/// What is said about a regime in a run from 2025 (the start) to 2065; empty for one that is accepted.
std::string problems_with(const std::string& text) {
    try {
        Regime::read(table_of(text), "regime", species_table(), slope_with_steep_part(), crane_lines,
                     {2025, 40});
    } catch (const config::InputError& error) {
        return error.what();
    }
    return {};
}

struct WrongValue {
    const char* file;
    const char* from;
    const char* to;
    const char* said;  ///< with the place, what was found and what was expected
};

const std::vector<WrongValue> wrong_values{
    // Salvage after storms: threshold, share, stumps, logs across, guards.
    {"salvage_only.csv", "salvage,salvage,1,1,20,", "salvage,salvage,1,1,-20,",
     "from_damage_m3pha = '-20', expected a number"},
    {"salvage_only.csv", ",20,0.8,", ",20,1.8,", "share = '1.8', expected a number in (0, 1]"},
    {"salvage_only.csv", ",0.33,1.2,70,", ",33,1.2,70,", "left_share = '33', expected a number in [0, 1]"},
    {"salvage_only.csv", ",0.33,1.2,70,", ",0.33,12,70,", "stump_height_m = '12'"},
    {"salvage_only.csv", ",1.2,70,8,", ",1.2,170,8,", "log_angle_deg = '170'"},
    {"salvage_only.csv", "salvage,0,1000,", "storm,0,1000,", "after 'storm'"},
    {"salvage_only.csv", "salvage,0,1000,", "salvage,1,1000,", "salvage is back on the same area"},
    {"salvage_only.csv", "600 300 100,10", "600 300 100,-10", "guard_years = '-10'"},
    {"salvage_only.csv", "600 300 100,10", "600 300 100,ten", "guard_years = 'ten'"},
    {"salvage_only.csv", "600 300 100,10", "600 300,10", "2 numbers for 3 species"},
    // Groups, with fences, plants and tending in the holes just cut.
    {"groups_fenced.csv", "groups,group_cut,2026,12,20,", "groups,group_cut,2026,12,2,", "side_m = '2'"},
    {"groups_fenced.csv", "fence,,,,,,,,,cuts_of:groups", "fence,,,,,,,,,cuts_of:gruops",
     "where 'cuts_of:gruops', expected 'cuts_of:groups'"},
    {"groups_fenced.csv", "fence,,,,,,,,,cuts_of:groups,0,15", "fence,,,,,,,,,cuts_of:groups,0,0",
     "fence_years = '0'"},
    {"groups_fenced.csv", "abal acps,,0.5", "abal acsp,,0.5", "species 'acsp'"},
    {"groups_fenced.csv", ",0.1,abal,", ",0.1,abla,", "species 'abla'"},
    // Corridors along lines and a selection between them in the same year.
    {"corridors_selection.csv", "cable_lines.csv", "lines_of_cable.csv", "lines_of_cable.csv"},
    {"corridors_selection.csv", "cable_lines.csv,12", "cable_lines.csv,0", "width_m = '0'"},
    {"corridors_selection.csv", "selection,2,2,12", "selection,1,2,12",
     "lines (line 3) and between on the same ground in year 2, expected different years"},
    {"corridors_selection.csv", ",30,60,10,1,", ",30,60,ten,1,", "retain_pha = 'ten'"},
    {"corridors_selection.csv", ",,,,1,25", ",,,,1,125", "from_slope_deg = '125'"},
    // Thinning to a basal area, of one species, with retention, where no gap is long; girdling.
    {"thin_spruce.csv", "1,15,35,piab", "1,15,0,piab", "to_basal_area_m2pha = '0'"},
    {"thin_spruce.csv", "35,piab,5", "35,pica,5", "species 'pica'"},
    {"thin_spruce.csv", "stands,25,,40", "stands,-25,,40", "to_gap_m = '-25'"},
    {"thin_spruce.csv", "stands,,40,,40,yes", "stands,,40,,40,oui", "girdled = 'oui', expected yes or no"},
    {"thin_spruce.csv", "stands,,40,,40,yes", "stands,,40,,0,yes", "from_dbh_cm"}};

TEST(OwnFiles, AreValid) {
    for (const char* file :
         {"salvage_only.csv", "groups_fenced.csv", "corridors_selection.csv", "thin_spruce.csv"}) {
        ASSERT_FALSE(text_of(file).empty()) << file;
        EXPECT_EQ(problems_with(text_of(file)), "") << file;
    }
}

TEST(OwnFiles, AreRefusedWithOneClearErrorForOneWrongValue) {
    for (const WrongValue& wrong : wrong_values) {
        std::string text = text_of(wrong.file);
        const std::size_t at = text.find(wrong.from);
        ASSERT_NE(at, std::string::npos) << wrong.file << ": " << wrong.from;
        ASSERT_EQ(text.find(wrong.from, at + 1), std::string::npos) << "twice: " << wrong.from;
        text.replace(at, std::string{wrong.from}.size(), wrong.to);
        const std::string said = problems_with(text);
        EXPECT_NE(said.find(wrong.said), std::string::npos) << wrong.file << ' ' << wrong.to << "\n" << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << "one error\n" << said;
    }
}

}  // namespace
}  // namespace coupling::own_files_test
