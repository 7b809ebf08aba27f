#include "forest/deadwood/deadwood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "forest/deadwood/decay.hpp"
#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::deadwood_test {
namespace {

class DeadWood : public testing::Test {
protected:
    void age(Stand& stand) const {
        stand.begin_year();
        age_dead_wood(stand, forest.site, forest.species, forest.weather, 1, 0);
    }
    [[nodiscard]] std::vector<Snag> whole_snags(std::size_t count, double dbh_cm) const {
        std::vector<Snag> snags;
        for (std::size_t i = 0; i < count; ++i) {
            snags.push_back({.tree = TreeId{i},
                             .x_m = 5.0,
                             .y_m = 5.0,
                             .species = spruce,
                             .dbh_cm = dbh_cm,
                             .tree_height_m = 25.0,
                             .height_m = 25.0,
                             .year = 2000,
                             .sound_kg = 500.0});
        }
        return snags;
    }

    const SmallForest forest{square_of_forest(2, 38.0)};
    const SpeciesId spruce = *forest.species.find("piab");
    const double speed = decay_speed(montane_year());
};

TEST_F(DeadWood, IsMadeOfTreesThatDieStanding) {
    std::vector<Tree> trees(3, new_tree(forest.species[spruce], spruce, 5.0, 5.0, 30.0, 25.0, 80.0));
    trees[2] = new_tree(forest.species[spruce], spruce, 5.0, 5.0, 6.0, 7.0, 20.0);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        trees[i].id = TreeId{i};
    }
    Stand stand{forest.grid, forest.species.size(), trees, 2000};
    stand.begin_year();
    stand.remove_trees(std::vector<Removal>{
        {TreeId{0}, Cause::stress}, {TreeId{1}, Cause::felled}, {TreeId{2}, Cause::stress}});
    age_dead_wood(stand, forest.site, forest.species, forest.weather, 1, 0);
    ASSERT_EQ(stand.dead_wood().snags.size(), 1U) << "felled ones are hauled off, thin ones leave nothing";
    const Snag& snag = stand.dead_wood().snags[0];
    EXPECT_EQ(snag.tree, TreeId{0});
    EXPECT_EQ(snag.height_m, 25.0);
    EXPECT_EQ(snag.density_share, 1.0);
}

TEST_F(DeadWood, FallsWithTheHalfLifeOfItsSpecies) {
    constexpr std::size_t count = 4000;
    constexpr int years = 12;
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    stand.add_snags(whole_snags(count, 40.0));
    for (int year = 0; year < years; ++year) {
        age(stand);
    }
    const double p =
        std::exp(-std::log(2.0) * speed * years / forest.species[spruce].deadwood.snag_half_life_years);
    EXPECT_NEAR(static_cast<double>(stand.dead_wood().snags.size()) / count, p,
                4.0 * std::sqrt(p * (1.0 - p) / count));
    double broken = 0.0;
    for (const Snag& snag : stand.dead_wood().snags) {
        broken += snag.height_m < 25.0 ? 1.0 : 0.0;
        EXPECT_TRUE(snag.height_m == 25.0 || (snag.height_m >= 1.0 && snag.height_m <= 5.0));
        EXPECT_NEAR(snag.density_share,
                    std::exp(-forest.species[spruce].deadwood.snag_decay_pyear * speed * years), 1e-9);
    }
    // Ten years with breakage, from the third on.
    const double whole = std::pow(1.0 - 0.1 * speed / 0.7, years - 2);
    const double standing = static_cast<double>(stand.dead_wood().snags.size());
    EXPECT_NEAR(broken / standing, 1.0 - whole, 4.0 * std::sqrt(whole * (1.0 - whole) / standing));
}

TEST_F(DeadWood, LosesMassByDecayAloneHoweverItFallsAndBreaks) {
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    stand.add_snags(whole_snags(500, 40.0));
    const Deadwood& law = forest.species[spruce].deadwood;
    for (int year = 0; year < 15; ++year) {
        double expected_kg = 0.0;
        for (Snag snag : stand.dead_wood().snags) {
            snag.density_share *= std::exp(-law.snag_decay_pyear * speed);
            expected_kg += mass_kg(snag);
        }
        for (Log log : stand.dead_wood().logs) {
            log.density_share *= std::exp(-lying_decay_pyear(law) * speed);
            expected_kg += mass_kg(log);
        }
        const double before_kg = stand.dead_wood_kg();
        age(stand);
        EXPECT_NEAR(stand.dead_wood_kg(), expected_kg, 1e-9 * expected_kg);
        EXPECT_NEAR(stand.balance().dead_wood_decayed_kg, before_kg - expected_kg, 1e-9 * expected_kg);
    }
    EXPECT_GT(stand.dead_wood().logs.size(), 300U);
}

TEST_F(DeadWood, FallsDownTheSlope) {
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    stand.add_snags(whole_snags(300, 15.0));
    for (int year = 0; year < 10; ++year) {
        age(stand);
    }
    ASSERT_GT(stand.dead_wood().logs.size(), 50U);
    double mean_east = 0.0;
    for (const Log& log : stand.dead_wood().logs) {
        // The slope faces south: within 60 degrees of it.
        EXPECT_LE(std::sin(log.direction_rad), -0.5 + 1e-9);
        mean_east += std::cos(log.direction_rad) / static_cast<double>(stand.dead_wood().logs.size());
        EXPECT_LT(log.thin_end_cm, log.thick_end_cm);
        EXPECT_GE(log.length_m, 20.0);
    }
    EXPECT_NEAR(mean_east, 0.0, 0.2);
}

TEST_F(DeadWood, LogsSettleKeepTheirDensityLawAndVanishInTheEnd) {
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    Log log{.tree = TreeId{7},
            .x_m = 5.0,
            .y_m = 5.0,
            .length_m = 10.0,
            .thick_end_cm = 40.0,
            .thin_end_cm = 25.0,
            .clearance_m = fresh_clearance_m,
            .species = spruce,
            .origin = LogOrigin::felled_crosswise,
            .anchored = true,
            .year = 2000};
    stand.add_logs(std::vector<Log>{log});
    for (int year = 0; year < 20; ++year) {
        age(stand);
    }
    ASSERT_EQ(stand.dead_wood().logs.size(), 1U);
    EXPECT_NEAR(stand.dead_wood().logs[0].clearance_m, 0.45 * std::exp(-20.0 / 12.0), 1e-9);
    EXPECT_NEAR(stand.dead_wood().logs[0].density_share,
                std::exp(-lying_decay_pyear(forest.species[spruce].deadwood) * speed * 20.0), 1e-9);
    for (int year = 0; year < 10; ++year) {
        age(stand);
    }
    EXPECT_EQ(stand.dead_wood().logs[0].clearance_m, 0.0);
    for (int year = 0; year < 150; ++year) {
        age(stand);
    }
    EXPECT_TRUE(stand.dead_wood().logs.empty());
}

TEST_F(DeadWood, RollsOffSteepSlopesOnceWeakAndLooseOnly) {
    const auto left_after = [&](bool anchored) {
        Stand stand{forest.grid, forest.species.size(), {}, 2000};
        std::vector<Log> logs;
        for (std::uint64_t i = 0; i < 1000; ++i) {
            logs.push_back({.tree = TreeId{i},
                            .x_m = 5.0,
                            .y_m = 5.0,
                            .length_m = 8.0,
                            .thick_end_cm = 35.0,
                            .thin_end_cm = 25.0,
                            .density_share = 0.4,
                            .species = spruce,
                            .origin = LogOrigin::felled_crosswise,
                            .anchored = anchored,
                            .year = 1980});
        }
        stand.add_logs(logs);
        for (int year = 0; year < 20; ++year) {
            age(stand);
        }
        return static_cast<double>(stand.dead_wood().logs.size()) / 1000.0;
    };
    EXPECT_EQ(left_after(true), 1.0);
    const double p = std::pow(0.99, 20.0);
    EXPECT_NEAR(left_after(false), p, 4.0 * std::sqrt(p * (1.0 - p) / 1000.0));
}

TEST_F(DeadWood, HasTheStemThatDied) {
    const Tree tree = new_tree(forest.species[spruce], spruce, 5.0, 5.0, 30.0, 25.0, 80.0);
    const double stem_m3 = stem_volume_m3(forest.species[spruce].allometry, 30.0, 25.0);
    Stand stand{forest.grid, forest.species.size(), {tree}, 2000};
    stand.begin_year();
    stand.remove_trees(std::vector<Removal>{{TreeId{0}, Cause::stress}});
    age_dead_wood(stand, forest.site, forest.species, forest.weather, 1, 0);
    EXPECT_DOUBLE_EQ(stand.dead_wood_kg(), tree.stem_kg);
    EXPECT_DOUBLE_EQ(stand.balance().stem_lost_kg[index_of(Cause::stress)], tree.stem_kg);
    EXPECT_NEAR(volume_m3(stand.dead_wood().snags[0], forest.species), stem_m3, 1e-12);
}

TEST_F(DeadWood, CountsWhatBecomesSoil) {
    Stand stand{forest.grid, forest.species.size(), {}, 2000};
    stand.add_snags(whole_snags(50, 40.0));
    stand.begin_year();
    double out_kg = 0.0;
    for (int year = 0; year < 250; ++year) {
        age(stand);
        out_kg += stand.balance().all_dead_wood_out_kg();
    }
    EXPECT_TRUE(stand.dead_wood().snags.empty() && stand.dead_wood().logs.empty());
    EXPECT_NEAR(out_kg, 50.0 * 500.0, 1e-6);
    // A tenth of the density on a sixth of the volume, a little less after the last year.
    EXPECT_GT(stand.total_balance().dead_wood_to_soil_kg, 0.75 * 50.0 * 500.0 / 60.0);
    EXPECT_LT(stand.total_balance().dead_wood_to_soil_kg, 50.0 * 500.0 / 60.0 + 1e-6);
}

TEST(WreckOf, SharesTheStemBetweenStumpAndLog) {
    Tree tree;
    tree.dbh_cm = 40.0;
    tree.height_m = 30.0;
    tree.stem_kg = 800.0;
    const Wreck broken = wreck_of(tree, 3.0, 0.0, LogOrigin::windthrow, 2000);
    EXPECT_NEAR(broken.stump->sound_kg, 800.0 * (1.0 - 0.9 * 0.9 * 0.9), 1e-9);
    EXPECT_NEAR(broken.stump->sound_kg + broken.log.sound_kg, 800.0, 1e-9);
    EXPECT_NEAR(wreck_of(tree, 0.0, 0.0, LogOrigin::windthrow, 2000).log.sound_kg, 800.0, 1e-9);
}

TEST(LogOfPiece, IsACutOfACone) {
    const Snag stem{.dbh_cm = 40.0, .tree_height_m = 27.3, .height_m = 27.3};
    const Log log = log_of_piece(stem, 1.3, 14.3, 0.0);
    EXPECT_DOUBLE_EQ(log.thick_end_cm, 40.0);
    EXPECT_DOUBLE_EQ(log.thin_end_cm, 20.0);
    EXPECT_DOUBLE_EQ(log.length_m, 13.0);
}

}  // namespace
}  // namespace forest::deadwood_test
