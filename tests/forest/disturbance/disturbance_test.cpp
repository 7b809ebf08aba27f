#include "forest/disturbance/disturbance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "config/options/options.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::disturbance_test {
namespace {

constexpr DisturbanceLaw everything{.wind = true,
                                    .snow = true,
                                    .beetle = true,
                                    .storm_interval_years = 2.0,
                                    .wet_snow_chance = 0.5,
                                    .beetle_in_windthrow = 0.5,
                                    .beetle_background = 0.5};

Stand mountain_spruces(const SmallForest& forest, bool reversed = false) {
    StandRecord record;
    for (std::uint32_t i = 0; i < forest.grid.size(); ++i) {
        record.patches.push_back(PatchId{i});
    }
    record.species = {{.species = *forest.species.find("piab"), .stems_pha = 500.0, .mean_dbh_cm = 32.0},
                      {.species = *forest.species.find("fasy"), .stems_pha = 100.0, .mean_dbh_cm = 25.0}};
    record.degree_days = 1300.0;
    std::vector<Tree> trees = trees_from_record(record, forest.grid, forest.species, 1, 0, 0);
    if (reversed) {
        std::reverse(trees.begin(), trees.end());
    }
    return {forest.grid, forest.species.size(), trees, 2000};
}

SpeciesDrought never_dry(const SmallForest& forest) {
    return {forest.grid.size(), forest.species.size()};
}

std::set<TreeId> lost_to(const Stand& stand, Cause cause) {
    std::set<TreeId> lost;
    for (const DeadTree& dead : stand.deaths()) {
        if (dead.cause == cause) {
            lost.insert(dead.tree.id);
        }
    }
    return lost;
}

TEST(Disturb, DoesNothingUnlessSwitchedOn) {
    const SmallForest forest{square_of_forest(6)};
    Stand stand = mountain_spruces(forest);
    stand.begin_year();
    for (std::uint32_t replicate = 0; replicate < 200; ++replicate) {
        disturb(stand, forest.site, forest.species, {forest.weather, 350.0, false}, never_dry(forest), {}, 1,
                replicate);
    }
    EXPECT_TRUE(stand.deaths().empty());
    EXPECT_TRUE(stand.dead_wood().logs.empty());
    EXPECT_TRUE(std::all_of(stand.patch_states().begin(), stand.patch_states().end(),
                            [](const PatchState& state) { return state.beetle_years == 0; }));
}

TEST(Disturb, LeavesTheChanceOfOneDisturbanceToItself) {
    const SmallForest forest{square_of_forest(16)};
    for (std::uint32_t replicate = 0; replicate < 5; ++replicate) {
        Stand both = mountain_spruces(forest);
        Stand snow = both;
        both.begin_year();
        snow.begin_year();
        DisturbanceLaw law = everything;
        law.storm_interval_years = 1.0;
        law.wet_snow_chance = 2.0;  // wet snow in every year
        disturb(both, forest.site, forest.species, {forest.weather, 350.0, false}, never_dry(forest), law, 1,
                replicate);
        law.wind = false;
        law.beetle = false;
        disturb(snow, forest.site, forest.species, {forest.weather, 350.0, false}, never_dry(forest), law, 1,
                replicate);
        EXPECT_EQ(lost_to(both, Cause::snow), lost_to(snow, Cause::snow));
        EXPECT_FALSE(lost_to(snow, Cause::snow).empty());
        EXPECT_TRUE(lost_to(snow, Cause::wind).empty());
    }
}

TEST(Disturb, BeginsInTheYearThatIsAskedFor) {
    SmallForest forest{square_of_forest(4)};
    forest.parameters.disturbance = everything;
    forest.parameters.disturbance.storm_interval_years = 1.0;
    Stand stand = mountain_spruces(forest);
    forest.parameters.disturbance.first_year = static_cast<std::uint64_t>(stand.year()) + 3;
    for (int year = 1; year <= 6; ++year) {
        static_cast<void>(forest.grow(stand));
        std::size_t disturbed = 0;
        for (const Cause cause : {Cause::wind, Cause::snow, Cause::beetle}) {
            disturbed += lost_to(stand, cause).size();
        }
        EXPECT_TRUE(year >= 3 || disturbed == 0) << year;
        EXPECT_TRUE(year != 3 || disturbed > 0) << "a storm each year";
    }
}

TEST(Disturb, HasBeetlesComeInFromOutsideInTheYearsAskedFor) {
    SmallForest forest{square_of_forest(10)};
    forest.parameters.disturbance = {.beetle = true, .beetle_background = 0.001};
    for (ClimateYear& year : forest.weather) {
        for (ClimateMonth& month : year.months) {  // two broods a year, and mild winters
            month.tave_degc += 5.0;
            month.tmin_degc += 5.0;
            month.tmax_degc += 5.0;
        }
    }
    constexpr int asked = 3;  // years after the start
    std::size_t more_in_the_year = 0;
    std::size_t more_after = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Stand usual = mountain_spruces(forest);
        Stand with = usual;
        SmallForest invaded = forest;
        invaded.parameters.disturbance.beetle_years = {static_cast<double>(usual.year() + asked)};
        invaded.parameters.disturbance.beetle_years_pha = 0.95;
        for (int year = 1; year <= asked + 2; ++year) {
            static_cast<void>(forest.grow(usual, seed));
            static_cast<void>(invaded.grow(with, seed));
            const std::size_t killed_usually = lost_to(usual, Cause::beetle).size();
            const std::size_t killed = lost_to(with, Cause::beetle).size();
            if (year < asked) {
                ASSERT_EQ(lost_to(with, Cause::beetle), lost_to(usual, Cause::beetle)) << "nothing before";
                ASSERT_EQ(with.mass_standing_kg(), usual.mass_standing_kg());
            } else {
                EXPECT_GE(killed, killed_usually);
                (year == asked ? more_in_the_year : more_after) += killed - killed_usually;
            }
        }
    }
    EXPECT_GT(more_in_the_year, 10U);
    EXPECT_GT(more_after, 0U) << "the outbreak lives on";
}

TEST(Disturb, HasBeetlesFromOutsideWhereMoreAreAskedForThanComeOfThemselves) {
    SmallForest forest{square_of_forest(10)};
    forest.parameters.disturbance = {.beetle = true, .beetle_background = 0.5};
    const auto killed_with = [&](const DisturbanceLaw& law) {
        SmallForest here = forest;
        here.parameters.disturbance = law;
        Stand stand = mountain_spruces(here);
        static_cast<void>(here.grow(stand));
        return lost_to(stand, Cause::beetle);
    };
    DisturbanceLaw law = forest.parameters.disturbance;
    const auto usual = killed_with(law);
    law.beetle_years = {static_cast<double>(mountain_spruces(forest).year() + 1)};
    law.beetle_years_pha = 0.1;
    EXPECT_EQ(killed_with(law), usual) << "never fewer";
    law.beetle_years_pha = 0.99;
    EXPECT_GT(killed_with(law).size(), usual.size());
    law.beetle = false;
    EXPECT_TRUE(killed_with(law).empty()) << "beetles are not simulated";
}

TEST(Disturb, KeepsTheBalanceThroughYearsOfStormsAndBeetles) {
    SmallForest forest{square_of_forest(10)};
    forest.parameters.disturbance = everything;
    Stand stand = mountain_spruces(forest);
    for (int year = 0; year < 15; ++year) {
        const Stand before = stand;
        static_cast<void>(forest.grow(stand));
        const StandBalance balance = stand.total_balance();
        EXPECT_EQ(stand.stems_at_start() + balance.all_stems_in(),
                  balance.all_stems_out() + stand.stems_standing());
        const double in_kg =
            stand.mass_at_start_kg() + balance.mass_in_kg + balance.grown_kg - balance.shed_kg;
        EXPECT_NEAR(in_kg, balance.all_lost_kg() + stand.mass_standing_kg(), 1e-9 * in_kg);
        for (const Tree& tree : stand.trees()) {
            const auto old = before.find(tree.id);
            EXPECT_TRUE(!old || tree.height_m >= before.trees()[*old].height_m) << "what breaks has died";
        }
    }
    const StandBalance balance = stand.total_balance();
    for (const Cause cause : {Cause::wind, Cause::snow, Cause::beetle}) {
        EXPECT_GT(balance.stems_out[index_of(cause)], 0U) << name_of(cause);
    }
    // Everything thicker than 7 cm that died left wood, thrown and broken stems logs.
    EXPECT_GT(stand.dead_wood().logs.size(), 20U);
    EXPECT_GT(stand.dead_wood().snags.size(), 20U);
}

TEST(Disturb, GivesTheSameBytesForAnyOrderOfTrees) {
    SmallForest forest{square_of_forest(8)};
    forest.parameters.disturbance = everything;
    Stand straight = mountain_spruces(forest);
    Stand reversed = mountain_spruces(forest, true);
    for (int year = 0; year < 6; ++year) {
        static_cast<void>(forest.grow(straight));
        static_cast<void>(forest.grow(reversed));
    }
    EXPECT_LT(straight.trees().size(), mountain_spruces(forest).trees().size());
    ASSERT_EQ(straight.trees().size(), reversed.trees().size());
    for (std::size_t i = 0; i < straight.trees().size(); ++i) {
        EXPECT_EQ(straight.trees()[i].id, reversed.trees()[i].id);
        EXPECT_EQ(straight.trees()[i].dbh_cm, reversed.trees()[i].dbh_cm);
    }
    ASSERT_EQ(straight.dead_wood().logs.size(), reversed.dead_wood().logs.size());
    for (std::size_t i = 0; i < straight.dead_wood().logs.size(); ++i) {
        EXPECT_EQ(straight.dead_wood().logs[i].tree, reversed.dead_wood().logs[i].tree);
        EXPECT_EQ(straight.dead_wood().logs[i].direction_rad, reversed.dead_wood().logs[i].direction_rad);
    }
}

TEST(Disturb, LetsBeetlesFollowAStormUnlessItsWoodIsCleared) {
    // The storm of 2001 throws trees; in 2002 beetles come out of them, or not if they have been taken away.
    const SmallForest forest{square_of_forest(16)};
    DisturbanceLaw storm{.wind = true, .storm_interval_years = 1.0};
    DisturbanceLaw beetles{.beetle = true, .beetle_in_windthrow = 0.8, .beetle_background = 0.0};
    double after_storm = 0.0;
    double after_clearing = 0.0;
    for (std::uint32_t replicate = 0; replicate < 5; ++replicate) {
        Stand stand = mountain_spruces(forest);
        stand.begin_year();
        disturb(stand, forest.site, forest.species, {forest.weather, 350.0, false}, never_dry(forest), storm,
                1, replicate);
        Stand cleared = stand;
        cleared.set_dead_wood({}, {});
        for (Stand* one : {&stand, &cleared}) {
            one->begin_year();
            disturb(*one, forest.site, forest.species, {forest.weather, 350.0, false}, never_dry(forest),
                    beetles, 1, replicate);
        }
        after_storm += static_cast<double>(lost_to(stand, Cause::beetle).size());
        after_clearing += static_cast<double>(lost_to(cleared, Cause::beetle).size());
    }
    EXPECT_GT(after_storm, 10.0);
    EXPECT_EQ(after_clearing, 0.0);
}

TEST(DisturbanceSettings, AreOffByDefaultAndReadFromTheirSection) {
    Parameters parameters;
    config::Options options;
    declare(options, parameters);
    EXPECT_FALSE(parameters.disturbance.wind || parameters.disturbance.snow || parameters.disturbance.beetle);
    std::istringstream text{"[disturbance]\nwind = yes\nbeetle = yes\nstorm_interval = 40\n"};
    options.read(text, "scenario.ini", {"disturbance.beetle_in_windthrow=0.8"});
    EXPECT_TRUE(parameters.disturbance.wind && parameters.disturbance.beetle);
    EXPECT_FALSE(parameters.disturbance.snow);
    EXPECT_EQ(parameters.disturbance.storm_interval_years, 40.0);
    EXPECT_EQ(parameters.disturbance.beetle_in_windthrow, 0.8);
}

}  // namespace
}  // namespace forest::disturbance_test
