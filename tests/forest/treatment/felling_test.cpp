#include "forest/treatment/felling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::felling_test {
namespace {

const SpeciesTable table = SpeciesTable::shipped();
const SpeciesId spruce = *table.find("piab");

/// Spruces of 40 cm and 30 m on a grid of spots 4 m apart, on a slope that faces south.
Stand spruces(int side) {
    std::vector<Tree> trees;
    for (int i = 0; i < side * side; ++i) {
        trees.push_back(new_tree(table[spruce], spruce, 2.0 + 4.0 * (i % side), 2.0 + 4.0 * (i / side), 40.0,
                                 30.0, 100.0));
        trees.back().id = TreeId{static_cast<std::uint64_t>(i)};
    }
    return {square_of_forest((4 * side + 9) / 10), table.size(), trees, 2000};
}

Picks all_of(const Stand& stand) {
    Picks picks(stand.trees().size());
    std::iota(picks.begin(), picks.end(), 0);
    return picks;
}

TEST(Fell, ReportsWhatWasTakenAndKeepsTheBalance) {
    Stand stand = spruces(10);
    const double stem_m3 = stem_volume_m3(table[spruce].allometry, 40.0, 30.0);
    const Timber timber = fell(stand, table, Picks{0, 3, 50}, {}, 1, 0);
    const TimberClass& cut = timber.by_species[index_of(spruce)][dbh_class_of(40.0)];
    EXPECT_EQ(cut.stems, 3.0);
    EXPECT_NEAR(cut.taken_m3 + cut.left_m3, 3.0 * stem_m3, 1e-9);
    EXPECT_NEAR(cut.left_m3 / (3.0 * stem_m3), 1.0 - std::pow(1.0 - 0.3 / 30.0, 3.0), 1e-9) << "stumps";
    EXPECT_EQ(timber.total().stems, 3.0);
    EXPECT_EQ(stand.trees().size(), 97U);
    EXPECT_EQ(stand.balance().stems_out[index_of(Cause::felled)], 3U);
    ASSERT_EQ(stand.dead_wood().snags.size(), 3U);
    EXPECT_TRUE(stand.dead_wood().snags[0].cut);
    EXPECT_DOUBLE_EQ(stand.dead_wood().snags[0].height_m, 0.3);
    EXPECT_TRUE(stand.dead_wood().logs.empty());
}

TEST(Fell, LeavesHighStumpsAndLogsAcrossTheSlope) {
    Stand stand = spruces(30);
    const Felling how{.stump_height_m = 1.3, .left_share = 0.3, .log_length_m = 8.0};
    const Timber timber = fell(stand, table, all_of(stand), how, 1, 0);
    const double p = static_cast<double>(stand.dead_wood().logs.size()) / 900.0;
    EXPECT_NEAR(p, 0.3, 4.0 * std::sqrt(0.21 / 900.0));
    double left_m3 = 0.0;
    int to_one_side = 0;
    for (const Log& log : stand.dead_wood().logs) {
        EXPECT_NEAR(log.length_m, 8.0, 1e-9);
        EXPECT_NEAR(log.thick_end_cm, 40.0, 1e-9);
        // 70 degrees to the fall line, which points south.
        EXPECT_NEAR(-std::sin(log.direction_rad), std::cos(70.0 * std::numbers::pi / 180.0), 1e-9);
        EXPECT_EQ(log.origin, LogOrigin::felled_crosswise);
        EXPECT_TRUE(log.anchored);
        to_one_side += std::cos(log.direction_rad) > 0.0 ? 1 : 0;
        left_m3 += 1.0;
    }
    EXPECT_GT(to_one_side, 0.3 * left_m3);
    EXPECT_LT(to_one_side, 0.7 * left_m3);
    EXPECT_DOUBLE_EQ(stand.dead_wood().snags[0].height_m, 1.3);
    EXPECT_GT(timber.total().left_m3, 0.1 * timber.total().taken_m3);
    // What is left is in the dead wood, what is taken has left the forest.
    const double density_kgpm3 = table[spruce].allometry.stem_density_kgpm3;
    EXPECT_NEAR(stand.dead_wood_kg(), timber.total().left_m3 * density_kgpm3, 1e-6);
    EXPECT_NEAR(stand.balance().all_stem_lost_kg() - stand.dead_wood_kg(),
                timber.total().taken_m3 * density_kgpm3, 1e-6);
}

TEST(Fell, DamagesNeighboursOnlyAndAsOftenAsItsShareSays) {
    Stand stand = spruces(40);
    Picks stripes;  // every fifth row: each row between has one felled 4 m away or none within 5 m
    for (std::size_t i = 0; i < stand.trees().size(); ++i) {
        if (i / 40 % 5 == 0) {
            stripes.push_back(i);
        }
    }
    fell(stand, table, stripes, {.damage_share = 0.3}, 1, 0);
    double beside = 0.0;
    double hurt = 0.0;
    for (const Tree& tree : stand.trees()) {
        const auto row = number_of(tree.id) / 40 % 5;
        const bool wounded = !stand.wounds_of(tree.id).empty();
        if (row == 1 || row == 4) {
            beside += number_of(tree.id) / 40 == 39 ? 0.0 : 1.0;
            hurt += wounded ? 1.0 : 0.0;
        } else {
            EXPECT_FALSE(wounded);
        }
    }
    EXPECT_NEAR(hurt / beside, 0.3, 4.0 * std::sqrt(0.21 / beside));
    EXPECT_NEAR(stand.wounds()[0].area_cm2, 200.0, 2.0);
}

TEST(Salvage, TakesItsShareOfFreshDeadWoodAndLeavesWhatWasLeftOnPurpose) {
    Stand stand = spruces(2);
    std::vector<Snag> snags;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        snags.push_back({.tree = TreeId{100 + i},
                         .x_m = 5.0,
                         .y_m = 5.0,
                         .species = spruce,
                         .dbh_cm = 30.0,
                         .tree_height_m = 25.0,
                         .height_m = 25.0,
                         .year = i < 1000 ? 2000 : 1990,
                         .sound_kg = 300.0});
    }
    stand.add_snags(snags);
    stand.add_logs(std::vector<Log>{{.tree = TreeId{9999},
                                     .x_m = 5.0,
                                     .y_m = 5.0,
                                     .length_m = 8.0,
                                     .thick_end_cm = 30.0,
                                     .species = spruce,
                                     .origin = LogOrigin::felled_crosswise,
                                     .year = 2000}});
    const Timber timber = salvage(stand, table, {}, 0.6, 2, {.stump_height_m = 0.0}, 1, 0).timber;
    EXPECT_NEAR(timber.total().stems / 1000.0, 0.6, 4.0 * std::sqrt(0.24 / 1000.0));
    EXPECT_EQ(static_cast<double>(stand.dead_wood().snags.size()), 2000.0 - timber.total().stems);
    EXPECT_EQ(stand.dead_wood().logs.size(), 1U);
    EXPECT_NEAR(stand.balance().dead_wood_taken_kg, 300.0 * timber.total().stems, 1e-6);
    EXPECT_NEAR(timber.total().taken_m3 * table[spruce].allometry.stem_density_kgpm3,
                stand.balance().dead_wood_taken_kg, 1e-6);
}

TEST(Salvage, LeavesStumpsAndAShareOfTheStemsAcrossTheSlope) {
    Stand stand = spruces(2);
    std::vector<Snag> snags;
    std::vector<Log> logs;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        snags.push_back({.tree = TreeId{100 + i},
                         .x_m = 5.0,
                         .y_m = 5.0,
                         .species = spruce,
                         .dbh_cm = 30.0,
                         .tree_height_m = 25.0,
                         .height_m = 25.0,
                         .year = 2000,
                         .sound_kg = 300.0});
        logs.push_back({.tree = TreeId{2000 + i},
                        .x_m = 5.0,
                        .y_m = 5.0,
                        .length_m = 20.0,
                        .thick_end_cm = 30.0,
                        .species = spruce,
                        .origin = LogOrigin::windthrow,
                        .year = 2000,
                        .sound_kg = 280.0});
    }
    stand.add_snags(snags);
    stand.add_logs(logs);
    const double before_kg = stand.dead_wood_kg();
    const Felling how{.stump_height_m = 1.0,
                      .left_share = 0.3,
                      .to_fall_line = config::Angle::from_degrees(60.0),
                      .anchored = true};
    const Timber timber = salvage(stand, table, {}, 1.0, 2, how, 1, 0).timber;
    EXPECT_EQ(timber.total().stems, 2000.0);
    EXPECT_EQ(stand.dead_wood().snags.size(), 1000U) << "a stump of each snag";
    for (const Snag& stump : stand.dead_wood().snags) {
        EXPECT_TRUE(stump.cut);
        EXPECT_EQ(stump.height_m, 1.0);
    }
    const auto left = static_cast<double>(stand.dead_wood().logs.size());
    EXPECT_NEAR(left / 2000.0, 0.3, 4.0 * std::sqrt(0.21 / 2000.0));
    const double down_rad = fall_line_of(stand.grid().patches().front()).in_radians();
    for (const Log& log : stand.dead_wood().logs) {
        EXPECT_EQ(log.origin, LogOrigin::felled_crosswise);
        EXPECT_NEAR(std::abs(log.direction_rad - down_rad), 60.0 * M_PI / 180.0, 1e-9);
    }
    // What was there was taken or stays.
    EXPECT_NEAR(stand.dead_wood_kg() + stand.balance().dead_wood_taken_kg, before_kg, 1e-6 * before_kg);
    const double density_kgpm3 = table[spruce].allometry.stem_density_kgpm3;
    EXPECT_NEAR(timber.total().taken_m3 * density_kgpm3, stand.balance().dead_wood_taken_kg,
                1e-6 * before_kg);
    EXPECT_NEAR(timber.total().left_m3 * density_kgpm3, stand.dead_wood_kg(), 1e-6 * before_kg);
}

TEST(Salvage, SaysFromWhichPatchesItTookStems) {
    Stand stand = spruces(10);  // 40 x 40 m
    std::vector<Log> logs;
    for (std::uint64_t i = 0; i < 16; ++i) {
        logs.push_back({.tree = TreeId{1000 + i},
                        .x_m = 5.0 + 10.0 * static_cast<double>(i % 4),
                        .y_m = 5.0 + 10.0 * static_cast<double>(i / 4),
                        .length_m = 8.0,
                        .thick_end_cm = 30.0,
                        .species = spruce,
                        .origin = LogOrigin::windthrow,
                        .year = 2000,
                        .sound_kg = 100.0});
    }
    stand.add_logs(logs);
    const TreatmentArea west{.polygons = {rectangle({10.0, 20.0}, 20.0, 40.0, {})}};
    const Salvaged done = salvage(stand, table, west, 0.6, 2, {.left_share = 0.5}, 1, 0);
    EXPECT_TRUE(std::is_sorted(done.patches.begin(), done.patches.end()));
    EXPECT_EQ(static_cast<double>(done.patches.size()), done.timber.total().stems) << "one log a patch";
    EXPECT_LT(done.patches.size(), 8U);
    EXPECT_GT(done.patches.size(), 0U);
    for (const PatchId patch : done.patches) {
        EXPECT_LT(stand.grid().x_centre_m(patch), 20.0);
    }
    std::size_t untouched = 0;
    for (const Log& log : stand.dead_wood().logs) {
        if (log.origin == LogOrigin::windthrow) {
            ++untouched;
            EXPECT_FALSE(std::binary_search(done.patches.begin(), done.patches.end(),
                                            *stand.grid().at(log.x_m, log.y_m)));
        }
    }
    EXPECT_EQ(untouched, 16U - done.patches.size());
    EXPECT_TRUE(salvage(stand, table, west, 0.6, 2, {}, 1, 0).patches.empty()) << "chance keeps the rest";
}

TEST(Fell, LeavesGirdledTreesStanding) {
    Stand stand = spruces(5);
    const double height_m = stand.trees()[0].height_m;
    const Timber timber = fell(stand, table, Picks{0}, {.left_share = 1.0, .girdled = true}, 1, 0);
    ASSERT_EQ(stand.dead_wood().snags.size(), 1U);
    EXPECT_TRUE(stand.dead_wood().logs.empty());
    EXPECT_FALSE(stand.dead_wood().snags[0].cut) << "a snag, not a stump";
    EXPECT_EQ(stand.dead_wood().snags[0].height_m, height_m);
    EXPECT_EQ(timber.total().taken_m3, 0.0);
    EXPECT_GT(timber.total().left_m3, 0.0);
}

TEST(Timber, AddsUp) {
    Stand stand = spruces(5);
    Timber sum;
    sum += fell(stand, table, Picks{0, 1}, {}, 1, 0);
    sum += fell(stand, table, Picks{0}, {}, 1, 0);
    EXPECT_EQ(sum.total().stems, 3.0);
}

}  // namespace
}  // namespace forest::felling_test
