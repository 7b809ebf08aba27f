#include "forest/disturbance/beetle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "forest/climate/summary.hpp"
#include "forest/disturbance/beetle_hosts.hpp"
#include "forest/disturbance/beetle_season.hpp"
#include "forest/stand/allometry.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::beetle_test {
namespace {

ClimateYear moved_year(double kelvin) {
    ClimateYear year = montane_year();
    for (ClimateMonth& month : year.months) {
        month.tave_degc += kelvin;
        month.tmin_degc += kelvin;
        month.tmax_degc += kelvin;
    }
    return year;
}

class Beetles : public testing::Test {
protected:
    // Tests say with the drought index of a patch how dry it is for spruce.

    /// A tree of this diameter on every patch of a square, in the shade of a stand.
    [[nodiscard]] Stand one_a_patch(const SmallForest& forest, SpeciesId species, double dbh_cm) const {
        std::vector<Tree> trees;
        for (std::size_t p = 0; p < forest.grid.size(); ++p) {
            const PatchId patch{static_cast<std::uint32_t>(p)};
            Tree tree = new_tree(table[species], species, forest.grid.x_centre_m(patch),
                                 forest.grid.y_centre_m(patch), dbh_cm, 20.0, 80.0);
            tree.id = TreeId{p};
            trees.push_back(tree);
        }
        Stand stand{forest.grid, table.size(), trees, 2000};
        stand.begin_year();
        change_patches(stand, [](PatchState& state, std::size_t) { state.ground_light = 0.15; });
        return stand;
    }
    template <class Change>
    static void change_patches(Stand& stand, Change change) {
        std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
        for (std::size_t p = 0; p < states.size(); ++p) {
            change(states[p], p);
        }
        stand.set_patch_states(states);
    }
    void attack(Stand& stand, const SmallForest& forest, double kelvin, const BeetleSources& sources,
                std::uint32_t replicate, std::span<const double> usual_summer_mm = {},
                double warmer_than_usual_dd = 0.0) const {
        const std::vector<ClimateYear> weather(forest.site.units().size(), moved_year(kelvin));
        change_patches(stand, [&](PatchState& state, std::size_t) {
            state.usual_degree_days = degree_days(weather.front()) - warmer_than_usual_dd;
        });
        SpeciesDrought drought{forest.grid.size(), table.size()};
        for (std::uint32_t p = 0; p < forest.grid.size(); ++p) {
            drought.set(PatchId{p}, spruce, 1.0 - stand.patch_states()[p].drought_index);
        }
        attack_by_beetles(stand, forest.site, table, {weather, 350.0, false, usual_summer_mm}, drought,
                          sources, 1, replicate);
    }
    static double wintering(const Stand& stand) {
        return static_cast<double>(std::count_if(stand.patch_states().begin(), stand.patch_states().end(),
                                                 [](const PatchState& s) { return s.beetle_years > 0; }));
    }
    static double killed(const Stand& stand) {
        return static_cast<double>(stand.balance().stems_out[index_of(Cause::beetle)]);
    }

    const SpeciesTable table = SpeciesTable::shipped();
    const SpeciesId spruce = *table.find("piab");
    static constexpr double too_cold_to_fly_k = -8.0;
    static constexpr double one_brood_k = 0.0;
    static constexpr double two_broods_k = 5.0;
};

TEST_F(Beetles, LoseMoreAndMoreToTheirEnemies) {
    EXPECT_EQ(lost_to_enemies(1, 6.0), 0.0);
    EXPECT_EQ(lost_to_enemies(4, 6.0), 0.0);
    EXPECT_NEAR(lost_to_enemies(5, 6.0), 1.0 / 3.0, 1e-12);
    EXPECT_EQ(lost_to_enemies(7, 6.0), 1.0);
}

TEST_F(Beetles, BeginOfThemselvesAsOftenAsTheirChanceSays) {
    const SmallForest forest{square_of_forest(20)};
    constexpr int replicates = 50;
    constexpr double pha = 0.9;
    const std::vector<double> usual_summer_mm(forest.site.units().size(), 165.0);
    double usual = 0.0;
    double wet = 0.0;
    double warm = 0.0;
    for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
        Stand stand = one_a_patch(forest, spruce, 30.0);
        attack(stand, forest, too_cold_to_fly_k, {0.0, pha}, replicate);
        usual += wintering(stand);
        EXPECT_EQ(killed(stand), 0.0);
        Stand in_rain = one_a_patch(forest, spruce, 30.0);
        attack(in_rain, forest, too_cold_to_fly_k, {0.0, pha}, replicate, usual_summer_mm);
        wet += wintering(in_rain);
        Stand in_heat = one_a_patch(forest, spruce, 30.0);
        attack(in_heat, forest, too_cold_to_fly_k, {0.0, pha}, replicate, {}, 400.0);
        warm += wintering(in_heat);
    }
    constexpr double draws = 400.0 * replicates;
    const double p = 1.0 - std::pow(1.0 - pha, 0.01);
    EXPECT_NEAR(usual / draws, p, 4.0 * std::sqrt(p * (1.0 - p) / draws));
    // 330 mm fell from June to August: twice as much as usual.
    const double odds = p / (1.0 - p) * std::pow(2.0, -0.9609);
    const double p_wet = odds / (1.0 + odds);
    EXPECT_NEAR(wet / draws, p_wet, 4.0 * std::sqrt(p_wet * (1.0 - p_wet) / draws));
    const double odds_in_heat = p / (1.0 - p) * std::exp(1.1);
    EXPECT_NEAR(std::exp(1.1), 3.0, 0.01) << "three times the odds with 400 degree-days more";
    const double p_warm = odds_in_heat / (1.0 + odds_in_heat);
    EXPECT_NEAR(warm / draws, p_warm, 4.0 * std::sqrt(p_warm * (1.0 - p_warm) / draws));
}

TEST_F(Beetles, LiveThroughWintersAsOftenAsTheirChanceSays) {
    const SmallForest forest{square_of_forest(20)};
    constexpr int replicates = 20;
    double alive = 0.0;
    for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
        Stand stand = one_a_patch(forest, spruce, 30.0);
        change_patches(stand, [](PatchState& state, std::size_t) { state.beetle_years = 1; });
        attack(stand, forest, too_cold_to_fly_k, {0.0, 0.0}, replicate);
        alive += wintering(stand);
    }
    const double p = winter_survival(cold_days(moved_year(too_cold_to_fly_k)));
    EXPECT_LT(p, 0.5);
    EXPECT_NEAR(alive / (400.0 * replicates), p, 4.0 * std::sqrt(p * (1.0 - p) / (400.0 * replicates)));
}

TEST_F(Beetles, KillOnlySprucesOfFifteenCentimetresAndKeepTheBalance) {
    const SmallForest forest{square_of_forest(8)};
    Stand stand{forest.grid, table.size(), any_trees(forest.grid, table, 2000, 3), 2000};
    const std::vector<Tree> before(stand.trees().begin(), stand.trees().end());
    stand.begin_year();
    change_patches(stand, [](PatchState& state, std::size_t) {
        state.beetle_years = 1;
        state.beetle_brood = 1.0F;
        state.drought_index = 0.8;
    });
    attack(stand, forest, two_broods_k, {0.0, 0.0}, 0);
    EXPECT_GT(stand.deaths().size(), 20U);
    for (const DeadTree& dead : stand.deaths()) {
        EXPECT_EQ(dead.tree.species, spruce);
        EXPECT_GE(dead.tree.dbh_cm, 15.0);
        EXPECT_EQ(dead.cause, Cause::beetle);
    }
    EXPECT_EQ(stand.stems_at_start(), stand.balance().all_stems_out() + stand.stems_standing());
    EXPECT_EQ(before.size(), stand.trees().size() + stand.deaths().size());
}

/// A stand of hosts in which one of another kind or size is thrown on each patch of a corner the year before.
TEST_F(Beetles, BreedInSprucesThatAStormThrewAndNobodyCleared) {
    const SmallForest forest{square_of_forest(12)};
    const auto deaths_with = [&](SpeciesId species, double dbh_cm, LogOrigin origin, int log_year) {
        Stand stand = one_a_patch(forest, spruce, 30.0);
        const Log log{.x_m = 15.0,
                      .y_m = 15.0,
                      .length_m = 20.0,
                      .thick_end_cm = dbh_cm,
                      .species = species,
                      .origin = origin,
                      .year = log_year};
        stand.add_logs(std::vector<Log>{log});
        change_patches(stand, [](PatchState& state, std::size_t) { state.drought_index = 0.5; });
        attack(stand, forest, one_brood_k, {1.0, 0.0}, 0);
        return killed(stand);
    };
    EXPECT_GE(deaths_with(spruce, 40.0, LogOrigin::windthrow, 2000), 1.0);
    EXPECT_EQ(deaths_with(spruce, 40.0, LogOrigin::windthrow, 2001), 0.0) << "the storm of this year";
    EXPECT_EQ(deaths_with(spruce, 40.0, LogOrigin::windthrow, 1999), 0.0) << "dried out";
    EXPECT_EQ(deaths_with(spruce, 14.0, LogOrigin::windthrow, 2000), 0.0);
    EXPECT_EQ(deaths_with(spruce, 40.0, LogOrigin::fallen, 2000), 0.0);
    EXPECT_EQ(deaths_with(*table.find("abal"), 40.0, LogOrigin::windthrow, 2000), 0.0);
    Stand cleared = one_a_patch(forest, spruce, 30.0);
    attack(cleared, forest, one_brood_k, {1.0, 0.0}, 0);
    EXPECT_EQ(killed(cleared), 0.0);
}

TEST_F(Beetles, SpreadByANormalDistanceAndWinterWhereTheyCame) {
    const SmallForest forest{square_of_forest(61)};
    constexpr std::size_t middle = 30 * 61 + 30;
    constexpr int replicates = 400;
    double square_m2 = 0.0;
    double taken = 0.0;
    for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
        Stand stand = one_a_patch(forest, spruce, 30.0);
        change_patches(stand, [](PatchState& s, std::size_t p) {
            s.beetle_years = p == middle ? 1 : 0;
            s.beetle_brood = p == middle ? 1.0F : 0.0F;
        });
        attack(stand, forest, one_brood_k, {0.0, 0.0}, replicate);
        for (std::size_t p = 0; p < forest.grid.size(); ++p) {
            if (stand.patch_states()[p].beetle_years == 0 || p == middle) {
                continue;
            }
            EXPECT_EQ(stand.patch_states()[p].beetle_years, 2U);
            EXPECT_NEAR(stand.patch_states()[p].beetle_brood, basal_area_m2(30.0) / 0.3, 1e-6);
            EXPECT_FALSE(stand.find(TreeId{p})) << "taken";
            const PatchId patch{static_cast<std::uint32_t>(p)};
            const double dx_m = forest.grid.x_centre_m(patch) - 305.0;
            const double dy_m = forest.grid.y_centre_m(patch) - 305.0;
            EXPECT_LT(std::sqrt(dx_m * dx_m + dy_m * dy_m), 257.0 + 10.0);
            square_m2 += dx_m * dx_m + dy_m * dy_m;
            taken += 1.0;
        }
    }
    // A share of the patches lives through the winter; each has a brood and its sister and sends 6 cohorts.
    // The first stays, and the others kill with the chance of a spruce of 80 years without stress.
    const double survival = winter_survival(cold_days(moved_year(one_brood_k)));
    constexpr double sent = 5.0;
    const double won = 0.15 * success_by_age(80.0) * success_by_share(1.0);
    const double expected = replicates * survival * sent * won;
    const double variance = replicates * (survival * sent * won * (1.0 - won) +
                                          survival * (1.0 - survival) * sent * won * sent * won);
    EXPECT_NEAR(taken, expected, 4.0 * std::sqrt(variance) + 0.03 * expected) << "some meet on a patch";
    // Places are rounded to patches of 10 m: 100 / 12 more a side.
    const double mean_m2 = 2.0 * (40.5 * 40.5 + 100.0 / 12.0);
    EXPECT_NEAR(square_m2 / taken, mean_m2, 4.0 * mean_m2 / std::sqrt(taken));
}

TEST_F(Beetles, FlyAsOftenAsTheirBroodsAllow) {
    const SmallForest forest{square_of_forest(40)};
    const auto mean_killed = [&](double kelvin, double drought, std::uint16_t outbreak) {
        double sum = 0.0;
        for (std::uint32_t replicate = 0; replicate < 20; ++replicate) {
            Stand stand = one_a_patch(forest, spruce, 60.0);
            change_patches(stand, [&](PatchState& state, std::size_t p) {
                state.beetle_years = p % 100 == 0 ? outbreak : 0;
                state.beetle_brood = p % 100 == 0 ? 1.0F : 0.0F;
                state.drought_index = drought;
            });
            attack(stand, forest, kelvin, {0.0, 0.0}, replicate);
            sum += killed(stand);
        }
        return sum / 20.0;
    };
    EXPECT_EQ(mean_killed(too_cold_to_fly_k, 0.0, 1), 0.0);
    EXPECT_GT(mean_killed(one_brood_k, 0.0, 1), 2.0);
    EXPECT_GT(mean_killed(two_broods_k, 0.0, 1), 1.4 * mean_killed(one_brood_k, 0.0, 1)) << "warmth";
    EXPECT_GT(mean_killed(one_brood_k, 0.5, 1), 2.0 * mean_killed(one_brood_k, 0.0, 1)) << "drought";
    EXPECT_LT(mean_killed(one_brood_k, 0.0, 4), mean_killed(one_brood_k, 0.0, 1)) << "enemies";
    EXPECT_EQ(mean_killed(one_brood_k, 0.0, 6), 0.0) << "enemies took them all";
}

/// What matters is how much spruce there is and how it stands.
TEST_F(Beetles, TakeAPartOfAMixedForestAndNearlyAllOfAPureDryOne) {
    const SmallForest forest{square_of_forest(20)};
    const auto share_killed = [&](int every, double drought) {
        double killed_stems = 0.0;
        double hosts = 0.0;
        for (std::uint32_t replicate = 0; replicate < 10; ++replicate) {
            std::vector<Tree> trees;
            for (std::size_t i = 0; i < 4 * forest.grid.size(); ++i) {
                const PatchId at{static_cast<std::uint32_t>(i / 4)};
                const SpeciesId kind = static_cast<int>(i) % every == 0 ? spruce : *table.find("fasy");
                trees.push_back(new_tree(table[kind], kind, forest.grid.x_centre_m(at),
                                         forest.grid.y_centre_m(at), 32.0, 25.0, 100.0));
                trees.back().id = TreeId{i};
                hosts += kind == spruce ? 1.0 : 0.0;
            }
            Stand stand{forest.grid, table.size(), trees, 2000};
            stand.begin_year();
            change_patches(stand, [&](PatchState& state, std::size_t p) {
                state.ground_light = 0.15;
                state.drought_index = drought;
                state.beetle_years = p % 40 == 0 ? 1 : 0;
                state.beetle_brood = p % 40 == 0 ? 1.0F : 0.0F;
            });
            attack(stand, forest, two_broods_k, {0.0, 0.0}, replicate);
            killed_stems += killed(stand);
        }
        return killed_stems / hosts;
    };
    EXPECT_LT(share_killed(5, 0.0), 0.02);
    const double pure = share_killed(1, 0.0);
    EXPECT_GT(pure, 0.01);
    EXPECT_LT(pure, 0.8) << "not all";
    EXPECT_GT(share_killed(1, 0.9), 1.5 * pure);
}

}  // namespace
}  // namespace forest::beetle_test
