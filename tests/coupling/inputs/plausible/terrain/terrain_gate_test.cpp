#include "coupling/inputs/plausible/terrain/terrain_gate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/plausible/terrain/spikes.hpp"
#include "tests/coupling/inputs/plausible/terrain/wrong_terrains.hpp"

namespace coupling::plausible::terrain::terrain_gate_test {
namespace {

std::string in_words(const std::vector<Verdict>& verdicts) {
    std::string words;
    for (const Verdict& verdict : verdicts) {
        words += (words.empty() ? "" : ", ") + std::string{verdict.rule} +
                 (verdict.finding.is_error ? " (error): " : ": ") + verdict.finding.found;
    }
    return words;
}

bool sees(const std::vector<Verdict>& verdicts, const Wrong& wrong) {
    return std::any_of(verdicts.begin(), verdicts.end(), [&](const Verdict& verdict) {
        return verdict.rule == wrong.rule && verdict.finding.is_error == wrong.is_error;
    });
}

TEST(TerrainGate, LetsGroundPass) {
    EXPECT_EQ(in_words(judge_heights(mountainside().field())), "");
    EXPECT_EQ(in_words(judge_heights(hills().field())), "");
    EXPECT_EQ(in_words(judge_heights(smooth_slope().field())), "");
}

/// The place of the cell, and no peak where the ground around is as rough.
TEST(TerrainGate, NamesALonePeak) {
    const Ground peak = smooth_slope().changed(
        [](double z, int row, int column) { return row == 61 && column == 37 ? z + 8.0 : z; });
    const std::string words = in_words(judge_heights(peak.field()));
    EXPECT_EQ(words, "spikes: 1 cell out of the ground around by up to 8 m, the first in row 62, column 38");
    const Ground blocks = smooth_slope().changed([](double z, int row, int column) {
        return row >= 50 && row < 70 && column >= 30 && column < 50 ? z + 4.0 * node(9, row, column) : z;
    });
    EXPECT_EQ(in_words(judge_heights(blocks.field())).find("out of the ground"), std::string::npos);
}

/// Ground of blocks and steps between the cells: no height of it depends on its neighbours.
Ground rough_ground(int seed, double height_m) {
    return {40, 40, 5.0, [=](int row, int column) {
                return 800.0 + 2.0 * row + 0.5 * height_m * node(seed, row, column);
            }};
}

std::string lone_cells(const Ground& ground) {
    const std::optional<Finding> finding = judge_spikes(ground.field());
    return finding ? finding->found : "";
}

/// Share of the cells to which a peak can be added that is then found, and found there.
double share_seen(const Ground& ground, double peak_m) {
    int seen = 0;
    int looked_at = 0;
    for (int row = 6; row + 6 < ground.rows; row += 7) {
        for (int column = 6; column + 6 < ground.columns; column += 7) {
            const Ground peak = ground.changed(
                [&](double z, int r, int c) { return r == row && c == column ? z + peak_m : z; });
            const std::string place =
                "the first in row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1);
            seen += lone_cells(peak).find(place) != std::string::npos ? 1 : 0;
            ++looked_at;
        }
    }
    return static_cast<double>(seen) / looked_at;
}

/// The rougher the ground around, the higher a peak has to be.
TEST(TerrainGate, SeesPeaksByTheRoughnessOfTheGround) {
    for (int seed = 100; seed < 130; ++seed) {
        for (const double height_m : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
            EXPECT_EQ(lone_cells(rough_ground(seed, height_m)), "") << seed << ", " << height_m;
        }
    }
    EXPECT_EQ(share_seen(rough_ground(100, 1.0), 4.0), 1.0);
    EXPECT_EQ(share_seen(rough_ground(100, 2.0), 8.0), 1.0);
    EXPECT_EQ(share_seen(rough_ground(100, 3.0), 12.0), 1.0);
    for (const double peak_m : {6.0, 9.0, 12.0}) {
        double before = 1.0;
        for (const double height_m : {1.0, 2.0, 3.0, 4.0, 6.0}) {
            const double seen = share_seen(rough_ground(100, height_m), peak_m);
            EXPECT_LE(seen, before) << height_m << ", " << peak_m;
            before = seen;
        }
        EXPECT_LT(before, 0.1) << peak_m << ": six usual bends are more than that";
    }
}

/// Cones of debris and smooth hollows at any size of cells.
TEST(TerrainGate, TakesConesAndHollowsForGround) {
    for (const double cell_m : {1.0, 5.0, 10.0, 25.0}) {
        const auto from_middle_m = [&](int row, int column) {
            return cell_m * std::hypot(row - 40.0, column - 40.0);
        };
        for (const double degrees : {15.0, 25.0, 35.0}) {
            const double steepness = std::tan(degrees * std::numbers::pi / 180.0);
            const Ground cone{80, 80, cell_m, [&](int row, int column) {
                                  return 3000.0 - steepness * from_middle_m(row, column);
                              }};
            EXPECT_EQ(in_words(judge_heights(cone.field())).find("out of the ground"), std::string::npos)
                << cell_m << ", " << degrees;
        }
        for (const double wide_m : {8.0, 20.0}) {
            const Ground hollow{80, 80, cell_m, [&](int row, int column) {
                                    const double share = from_middle_m(row, column) / wide_m;
                                    return 1000.0 + 0.3 * cell_m * row -
                                           0.75 * wide_m * std::exp(-0.5 * share * share);
                                }};
            if (wide_m >= cell_m) {
                EXPECT_EQ(in_words(judge_heights(hollow.field())).find("out of the ground"),
                          std::string::npos)
                    << cell_m << ", " << wide_m;
            }
        }
    }
}

TEST(TerrainGate, SeesEachWrongTerrain) {
    for (const Wrong& wrong : wrong_terrains()) {
        const std::vector<Verdict> verdicts = judge_heights(wrong.ground.field());
        EXPECT_TRUE(sees(verdicts, wrong)) << wrong.what << ": " << in_words(verdicts);
    }
}

TEST(TerrainGate, HasAWrongTerrainForEachRule) {
    std::map<std::string, int> count;
    for (const Wrong& wrong : wrong_terrains()) {
        ++count[wrong.rule];
    }
    for (const Rule& rule : all_rules()) {
        EXPECT_GT(count[std::string{rule.name}], 0) << rule.name << ": add a terrain to wrong_terrains()";
    }
}

/// All rules over all terrains: a rule that is added to the list is held to it.
TEST(TerrainGate, SaysTheSameOfATurnedAndOfAMirroredTerrain) {
    std::vector<Wrong> terrains = wrong_terrains();
    terrains.push_back({"ground", "", false, mountainside()});
    terrains.push_back({"hills", "", false, hills()});
    for (const Wrong& terrain : terrains) {
        for (const Rule& rule : all_rules()) {
            const std::optional<Finding> expected = rule.judge(terrain.ground.field());
            Ground other = terrain.ground;
            for (int quarter = 0; quarter < 4; ++quarter, other = other.turned()) {
                for (const Ground& seen : {other, other.mirrored()}) {
                    const std::optional<Finding> found = rule.judge(seen.field());
                    ASSERT_EQ(found.has_value(), expected.has_value()) << rule.name << ", " << terrain.what;
                    if (found) {
                        EXPECT_EQ(found->is_error, expected->is_error) << rule.name << ", " << terrain.what;
                        EXPECT_EQ(found->advice, expected->advice) << rule.name << ", " << terrain.what;
                    }
                }
            }
        }
    }
}

TEST(TerrainGate, SaysNothingOfEvenPlanesAndProfiles) {
    for (const double rise_m : {0.0, 1.0, 5.0, 8.5}) {  // up to 59.5 degrees
        const Ground plane{60, 80, 5.0, [&](int row, int) { return 100.0 + rise_m * row; }};
        EXPECT_EQ(in_words(judge_heights(plane.field())), "") << rise_m;
    }
    const Ground wall{60, 80, 5.0, [](int row, int) { return 100.0 + 30.0 * row; }};
    EXPECT_EQ(in_words(judge_heights(wall.field())), "steepness: 100 % of the cells steeper than 60 degrees");
    const Ground cliff{60, 80, 5.0,
                       [](int row, int) { return row < 30 ? 2.0 * row : 60.0 + 12.0 * (row - 30); }};
    EXPECT_EQ(in_words(judge_heights(cliff.field())), "");
}

TEST(TerrainGate, DoesNotTakeCellsOfZeroForHollowsOfTheGround) {
    const Ground real = hills();
    const Ground zeros = real.changed(
        [](double z, int row, int column) { return row % 11 == 5 && column % 13 == 6 ? 0.0 : z; });
    const auto rule = std::find_if(all_rules().begin(), all_rules().end(),
                                   [](const Rule& each) { return each.name == "upside_down"; });
    ASSERT_NE(rule, all_rules().end());
    EXPECT_FALSE(rule->judge(zeros.field())) << "the rule on NODATA names them";
}

TEST(TerrainGate, SaysNothingWhereFewCellsAreKnown) {
    const Ground small{9, 10, 5.0, [](int row, int column) { return node(1, row, column) * 300.0; }};
    EXPECT_EQ(in_words(judge_heights(small.field())), "");
    const Ground none{40, 40, 5.0, [](int, int) { return std::numeric_limits<double>::quiet_NaN(); }};
    EXPECT_EQ(in_words(judge_heights(none.field())), "");
}

TEST(TerrainGate, TakesALevelLakeBelowACliffForGround) {
    const Ground real = mountainside();
    const Ground lake = real.changed([](double z, int, int) { return std::max(z, 1000.0); });
    EXPECT_EQ(in_words(judge_heights(lake.field())), "");
}

TEST(TerrainGate, DoesNotCountUnknownCells) {
    const Ground real = mountainside();
    const Ground holes = real.changed([](double z, int row, int column) {
        return node(4, row / 6, column / 6) > 0.5 ? std::numeric_limits<double>::quiet_NaN() : z;
    });
    EXPECT_EQ(in_words(judge_heights(holes.field())), "");
}

}  // namespace
}  // namespace coupling::plausible::terrain::terrain_gate_test
