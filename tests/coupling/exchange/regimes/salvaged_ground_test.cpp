// Rows that act where another row has salvaged (where = cuts_of:ROW).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "config/random/stream.hpp"
#include "tests/coupling/exchange/regimes/worked.hpp"
#include "tests/coupling/parts_of_text.hpp"

namespace coupling::salvaged_ground_test {
namespace {

using Patches = std::set<forest::PatchId>;

/// Trees by chance thrown by wind: each lies where it stood.
void throw_trees(forest::Stand& stand, double share, std::uint64_t storm) {
    std::vector<forest::Removal> removals;
    std::vector<forest::Log> logs;
    for (const forest::Tree& tree : stand.trees()) {
        config::RandomStream stream{{storm, 0, 0, forest::number_of(tree.id)}, config::Purpose::test};
        if (stream.uniform() < share) {
            removals.push_back({tree.id, forest::Cause::wind});
            logs.push_back({.tree = tree.id,
                            .x_m = tree.x_m,
                            .y_m = tree.y_m,
                            .length_m = tree.height_m,
                            .thick_end_cm = tree.dbh_cm,
                            .species = tree.species,
                            .origin = forest::LogOrigin::windthrow,
                            .year = stand.year(),
                            .sound_kg = 100.0});
        }
    }
    stand.remove_trees(removals);
    stand.add_logs(logs);
}

/// Patches by the windthrown logs on them.
std::map<forest::TreeId, forest::PatchId> lying(const forest::Stand& stand) {
    std::map<forest::TreeId, forest::PatchId> logs;
    for (const forest::Log& log : stand.dead_wood().logs) {
        if (log.origin == forest::LogOrigin::windthrow) {
            logs[log.tree] = *stand.grid().at(log.x_m, log.y_m);
        }
    }
    return logs;
}

/// Where windthrown logs were that lie there no more.
Patches salvaged(std::map<forest::TreeId, forest::PatchId> before, const forest::Stand& after) {
    for (const auto& [tree, patch] : lying(after)) {
        before.erase(tree);
    }
    Patches patches;
    for (const auto& [tree, patch] : before) {
        patches.insert(patch);
    }
    return patches;
}

Patches planted(const forest::Stand& stand) {
    Patches patches;
    for (const forest::Cohort& cohort : stand.cohorts()) {
        patches.insert(cohort.patch);
    }
    return patches;
}

const Entry* entry_of(const RegimeReport& report, const std::string& row) {
    const auto found = std::find_if(report.entries.begin(), report.entries.end(),
                                    [&](const Entry& entry) { return entry.intervention == row; });
    return found == report.entries.end() ? nullptr : &*found;
}

TEST(SalvagedGround, IsFencedAtOnceAndPlantedInTheYearAfterThoughSalvageComesEachYear) {
    const std::string regime =
        "name,treatment,every_years,share,left_share,from_damage_m3pha,where,after_years,fence_years,species,"
        "plants_pha\n"
        "salvage,salvage,1,0.6,0.2,1,,,,,\n"
        "fences,fence,,,,,cuts_of:salvage,,15,,\n"
        "planting,plant,,,,,cuts_of:salvage,1,,abal,20000\n";
    forest::Stand stand = spruce_stand(10);
    const Regime read = regime_of(regime, stand.grid());
    RegimeState state;
    Patches last_year;
    Patches ever;
    for (int year = 0; year <= 8; ++year) {
        stand.begin_year();
        const bool storm = year == 2 || year == 3 || year == 6;
        throw_trees(stand, storm ? 0.06 : 0.0, static_cast<std::uint64_t>(year));
        const auto before = lying(stand);
        const Patches planted_before = planted(stand);
        const RegimeReport report = apply(read, year, stand, species_table(), state, {1, 0});
        const Patches now = salvaged(before, stand);
        EXPECT_EQ(!now.empty(), storm) << "what was left is not taken without damage";
        const Entry* fences = entry_of(report, "fences");
        ASSERT_EQ(fences != nullptr, storm);
        if (storm) {
            ASSERT_LT(now.size(), before.size()) << "some stay";
            EXPECT_NEAR(fences->area_ha, 0.01 * static_cast<double>(now.size()), 1e-9);
            Patches unfenced;
            std::set_difference(now.begin(), now.end(), ever.begin(), ever.end(),
                                std::inserter(unfenced, unfenced.begin()));
            EXPECT_GE(fences->fenced_ha, 0.01 * static_cast<double>(unfenced.size()) - 1e-9);
        }
        const Entry* planting = entry_of(report, "planting");
        ASSERT_EQ(planting != nullptr, !last_year.empty()) << year;
        if (planting != nullptr) {
            EXPECT_NEAR(planting->area_ha, 0.01 * static_cast<double>(last_year.size()), 1e-9);
            Patches wanted = planted_before;
            wanted.insert(last_year.begin(), last_year.end());
            EXPECT_EQ(planted(stand), wanted) << "200 plants a patch: exactly the ground of last year";
        }
        ever.insert(now.begin(), now.end());
        last_year = now;
    }
    EXPECT_EQ(state.cuts.size(), 3U) << "one for each salvage that took something";
}

TEST(SalvagedGround, IsKeptByAreaAndSharedByRowsThatComeAgainAndAgain) {
    const std::string regime =
        "name,treatment,first_year,every_years,share,where,species\n"
        "salvage,salvage,0,1,0.9,stands,\n"
        "tending,tend,0,1,0.5,cuts_of:salvage,abal\n";
    forest::Stand stand = spruce_stand(6);
    const Regime read = regime_of(regime, stand.grid());
    RegimeState state;
    std::vector<std::size_t> areas;
    for (int year = 0; year <= 3; ++year) {
        stand.begin_year();
        throw_trees(stand, year == 0 || year == 2 ? 0.3 : 0.0, static_cast<std::uint64_t>(year));
        const RegimeReport report = apply(read, year, stand, species_table(), state, {1, 0});
        const Entry* tending = entry_of(report, "tending");
        areas.push_back(tending == nullptr ? 0 : tending->areas);
        if (tending != nullptr) {
            double all_ha = 0.0;
            for (const RegimeState::Cut& cut : state.cuts) {
                all_ha += cut.area.area_ha;
            }
            EXPECT_NEAR(tending->area_ha, all_ha, 1e-9);
        }
    }
    ASSERT_GE(areas[0], 2U) << "a cut in each of the two stands, in the year itself";
    EXPECT_EQ(areas[0], 2U);
    EXPECT_GE(areas[2], 4U) << "those of before and those of the year in one entry";
    EXPECT_EQ(areas[3], state.cuts.size());
    for (const RegimeState::Cut& cut : state.cuts) {
        const std::uint32_t stand_number = stand.grid()[cut.area.patches.front()].management_unit;
        for (const forest::PatchId patch : cut.area.patches) {
            EXPECT_EQ(stand.grid()[patch].management_unit, stand_number);
        }
    }
}

TEST(SalvagedGround, IsCutInLaterYearsAlone) {
    const std::string head = "name,treatment,every_years,share,where,after_years\nsalvage,salvage,1,0.9,,\n";
    const auto said = [&](const std::string& row) { return problems_of(head + row, two_stands(6)); };
    EXPECT_EQ(said("again,clear_cut,,,cuts_of:salvage,1\n"), "");
    EXPECT_TRUE(text_checks::has(said("again,clear_cut,,,cuts_of:salvage,\n"),
                                 "1 or more for a row that cuts or salvages"));
    EXPECT_TRUE(text_checks::has(said("again,salvage,,0.5,cuts_of:salvage,\n"),
                                 "1 or more for a row that cuts or salvages"));
    EXPECT_EQ(said("again,salvage,,0.5,cuts_of:salvage,2\n"), "");

    forest::Stand stand = spruce_stand(6);
    const Regime read = regime_of(head + "again,clear_cut,,,cuts_of:salvage,1\n", stand.grid());
    RegimeState state;
    stand.begin_year();
    throw_trees(stand, 0.2, 1);
    EXPECT_EQ(entry_of(apply(read, 0, stand, species_table(), state, {1, 0}), "again"), nullptr);
    ASSERT_EQ(state.cuts.size(), 1U);
    stand.begin_year();
    const RegimeReport report = apply(read, 1, stand, species_table(), state, {1, 0});
    ASSERT_NE(entry_of(report, "again"), nullptr);
    const std::vector<forest::PatchId> ground = state.cuts[0].area.patches;
    const auto on_an_edge = [](double metres) { return std::fmod(metres, forest::patch_side_m) == 0.0; };
    for (const forest::Tree& tree : stand.trees()) {
        if (on_an_edge(tree.x_m) || on_an_edge(tree.y_m)) {
            continue;  // it may count to the patch beside
        }
        EXPECT_FALSE(std::binary_search(ground.begin(), ground.end(), tree.patch)) << "all of it is cut";
    }
    EXPECT_TRUE(books_close(stand));
}

TEST(SalvagedGround, IsProposedWhereARowFollowsAYearlySalvage) {
    const std::string regime =
        "name,treatment,every_years,share,after,after_years,species,plants_pha\n"
        "salvage,salvage,1,0.9,,,,\nplanting,plant,,,salvage,1,abal,2000\n";
    EXPECT_TRUE(
        text_checks::has(problems_of(regime, two_stands(6)), "or where = cuts_of:salvage instead of"));
}

}  // namespace
}  // namespace coupling::salvaged_ground_test
