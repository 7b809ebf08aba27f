#include "coupling/exchange/yearly_rockfall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "coupling/assessments/decades/members/record_falls.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::exchange::yearly_rockfall_test {
namespace {

/// A slope with rocks and a forest from stand records.
struct RockySlope {
    RockySlope()
        : opened{open(project, {"trees.file=", "stands.records=records.csv", "release.rocks=200"})},
          season{*opened.scenario, *opened.site, forest().species.fracture_energy, {}} {}

    [[nodiscard]] const ForestSite& forest() const { return *opened.site->forest; }
    [[nodiscard]] YearFalls fall(const forest::Stand& stand) const {
        return season.simulate(stand, 0, 1, true, 1);
    }
    [[nodiscard]] forest::Stand without_trees() const {
        return {forest().grid, forest().species.table.size(), {}, forest().first_year() - 1};
    }

    ForestProject project;
    Opened opened;
    YearlyRockfall season;
};

/// The first tree that each rock meets.
std::map<std::uint64_t, forest::Impact> first_hits(const YearFalls& falls) {
    std::map<std::uint64_t, forest::Impact> first;
    for (const RockHit& hit : falls.hits) {
        first.try_emplace(hit.rock, hit.impact);
    }
    return first;
}

/// Anchored logs across the slope, which falls eastward, below all sources. 78 m are its whole width.
std::vector<forest::Log> logs_across(int count, double length_m, int year) {
    std::vector<forest::Log> logs;
    for (int i = 0; i < count; ++i) {
        logs.push_back({.tree = forest::TreeId{static_cast<std::uint64_t>(i)},
                        .x_m = 1065.0 + 5.0 * i,
                        .y_m = 2011.0,
                        .direction_rad = 1.5707963267948966,
                        .length_m = length_m,
                        .thick_end_cm = 60.0,
                        .thin_end_cm = 60.0,
                        .anchored = true,
                        .year = year});
    }
    return logs;
}

TEST(RocksOfAYear, TellHitsByWhatASoundStemTakes) {
    // Rot is the forest's affair: it divides by the stem's strength itself (forest/deaths/wounds).
    const RockySlope slope;
    forest::Stand stand = slope.forest().start(1, 0);
    const auto sound = first_hits(slope.fall(stand));
    std::vector<forest::Rot> rots;
    for (const forest::Tree& tree : stand.trees()) {
        rots.push_back({.since_year = 1990,
                        .from_m = 0.0F,
                        .to_m = 5.0F,
                        .depth_cm = static_cast<float>(0.45 * tree.dbh_cm)});
    }
    stand.set_rots(rots);
    const auto rotten = first_hits(slope.fall(stand));
    ASSERT_GT(sound.size(), 50U);
    ASSERT_EQ(rotten.size(), sound.size());
    for (const auto& [rock, hit] : sound) {
        EXPECT_EQ(rotten.at(rock).tree, hit.tree);
        EXPECT_DOUBLE_EQ(rotten.at(rock).energy_share, hit.energy_share);
    }
}

TEST(RocksOfAYear, KeepSomePathsThatChangeNothing) {
    const RockySlope slope;
    const forest::Stand stand = slope.forest().start(1, 0);
    const YearFalls with = slope.fall(stand);
    const YearFalls without = slope.season.simulate(stand, 0, 1, false, 1);
    EXPECT_TRUE(without.paths.empty());
    ASSERT_FALSE(with.paths.empty());
    EXPECT_LE(with.paths.size(), most_paths);
    EXPECT_EQ(with.hits.size(), without.hits.size());
    decades::MemberYears kept;
    decades::record_paths(with, 1, kept);
    std::size_t corners = 0;
    for (const rockfall::PathRecord& path : with.paths) {
        EXPECT_EQ(path.cover, Cover::forest);
        EXPECT_GE(path.points.size(), 2U);
        corners += path.points.size();
    }
    EXPECT_EQ(kept.paths.size(), corners);
    EXPECT_DOUBLE_EQ(kept.paths.front().z_m, with.paths.front().points.front().position_m.z());
}

TEST(RocksOfAYear, AreTheSameWhereNobodyReadsTheirCells) {
    const RockySlope slope;
    const forest::Stand stand = slope.forest().start(1, 0);
    std::array<decades::MemberYears, 2> kept;
    for (const bool with_cells : {false, true}) {
        const BareYear bare = slope.season.simulate_bare(0, 1, with_cells, 1);
        const YearFalls falls = slope.season.simulate(stand, bare, 0, false, 1);
        EXPECT_EQ(falls.tally.cells[index_of(Cover::forest)].cells.empty(), !with_cells);
        EXPECT_EQ(falls.tally.cells[index_of(Cover::bare)].cells.empty(), !with_cells);
        decades::record_falls(falls, 1, kept[with_cells ? 1 : 0]);
    }
    ASSERT_FALSE(kept[0].targets.empty());
    ASSERT_EQ(kept[0].targets.size(), kept[1].targets.size());
    for (std::size_t i = 0; i < kept[0].targets.size(); ++i) {
        EXPECT_EQ(kept[0].targets[i].paired.both, kept[1].targets[i].paired.both);
        EXPECT_EQ(kept[0].targets[i].paired.only_forest, kept[1].targets[i].paired.only_forest);
        EXPECT_EQ(kept[0].targets[i].paired.only_bare, kept[1].targets[i].paired.only_bare);
    }
    ASSERT_EQ(kept[0].energies.size(), kept[1].energies.size());
    for (std::size_t i = 0; i < kept[0].energies.size(); ++i) {
        EXPECT_EQ(kept[0].energies[i].bin, kept[1].energies[i].bin);
        EXPECT_EQ(kept[0].energies[i].rocks, kept[1].energies[i].rocks);
    }
}

TEST(RocksOfAYear, KeepTheEnergyAndSizeOfEachRockAtATarget) {
    const RockySlope slope;
    for (const bool with_forest : {true, false}) {
        const forest::Stand stand = with_forest ? slope.forest().start(1, 0) : slope.without_trees();
        const YearFalls falls = slope.fall(stand);
        decades::MemberYears kept;
        decades::record_falls(falls, 1, kept);
        auto rock = kept.rocks_at_targets.begin();
        for (const decades::TargetRow& row : kept.targets) {
            for (const auto& [figures, count] :
                 {std::pair{&row.forest, row.paired.forest()}, std::pair{&row.bare, row.paired.bare()}}) {
                ASSERT_EQ(figures->share.part, count);
                double sum_kj = 0.0;
                for (std::uint64_t i = 0; i < count; ++i, ++rock) {
                    ASSERT_NE(rock, kept.rocks_at_targets.end());
                    sum_kj += static_cast<double>(rock->energy_j) / 1000.0;
                    EXPECT_FLOAT_EQ(rock->diameter_m, 0.5F);
                }
                if (count > 0) {  // a sum of whole joules
                    EXPECT_NEAR(sum_kj / static_cast<double>(count), figures->energy_kj.mean, 1e-3);
                }
            }
        }
        EXPECT_EQ(rock, kept.rocks_at_targets.end());
        EXPECT_GT(kept.targets.front().paired.bare(), 20U);
    }
}

TEST(RocksOfAYear, SeeNoForestWhereNothingStandsOrLies) {
    const RockySlope slope;
    EXPECT_FALSE(slope.fall(slope.without_trees()).with_forest);
}

TEST(RocksOfAYear, FallAmongLivingTreesAsIfAllFellAgain) {
    const RockySlope slope;
    forest::Stand stand = slope.forest().start(1, 0);
    stand.add_logs(logs_across(2, 39.0, stand.year()));
    const BareYear bare = slope.season.simulate_bare(0, 1, false, 1);
    const YearFalls falls = slope.season.simulate(stand, bare, 0, false, 1);
    const auto met = std::count(falls.met_dead_wood.begin(), falls.met_dead_wood.end(), true);
    EXPECT_GT(met, 20);
    EXPECT_LT(met, static_cast<std::ptrdiff_t>(slope.season.rocks()) - 20);
    YearFalls all;
    all.with_forest = true;
    all.met_dead_wood.assign(slope.season.rocks(), true);
    all.past_dead_wood.resize(bare.targets.size());
    const auto again = slope.season.simulate_living(stand, bare, all, 0, 1);
    const auto few = slope.season.simulate_living(stand, bare, falls, 0, 1);
    ASSERT_FALSE(again.empty());
    ASSERT_EQ(few.size(), again.size());
    for (std::size_t target = 0; target < few.size(); ++target) {
        EXPECT_EQ(few[target].both, again[target].both);
        EXPECT_EQ(few[target].only_forest, again[target].only_forest);
        EXPECT_EQ(few[target].only_bare, again[target].only_bare);
        EXPECT_GT(few[target].both, 0U);
    }
}

TEST(RocksOfAYear, AreStoppedByLogsOfTheForest) {
    const RockySlope slope;
    forest::Stand stand = slope.without_trees();
    stand.add_logs(logs_across(4, 78.0, stand.year()));
    const YearFalls falls = slope.fall(stand);
    ASSERT_TRUE(falls.with_forest);
    ASSERT_EQ(falls.tally.logs.size(), 4U);
    EXPECT_GT(falls.tally.logs[0].hits, 50U);
    const auto forest = static_cast<std::size_t>(Cover::forest);
    const auto bare = static_cast<std::size_t>(Cover::bare);
    EXPECT_LT(falls.tally.targets[0].by_cover[forest].reached, falls.tally.targets[0].by_cover[bare].reached);
    EXPECT_EQ(falls.tally.targets[0].by_cover[bare].reached,
              slope.fall(slope.without_trees()).tally.targets[0].by_cover[bare].reached);
}

}  // namespace
}  // namespace coupling::exchange::yearly_rockfall_test
