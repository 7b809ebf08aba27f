#include "forest/start/starting_dead_wood.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/deadwood/deadwood.hpp"
#include "forest/treatment/area.hpp"
#include "tests/forest/small_forest.hpp"

namespace forest::starting_dead_wood_test {
namespace {

const SpeciesTable& species() {
    static const SpeciesTable table = SpeciesTable::shipped();
    return table;
}

OnPatches<DeadWoodRecord> on_all(const PatchGrid& grid, DeadWoodRecord record) {
    OnPatches<DeadWoodRecord> stand{.records = {record}, .degree_days = 1300.0};
    record.species = *species().find("piab");
    stand.records = {record};
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        stand.patches.push_back(PatchId{i});
    }
    return stand;
}

double volume_m3pha(const SnagsAndLogs& wood, const PatchGrid& grid) {
    double sum_m3 = 0.0;
    for (const Snag& snag : wood.snags) {
        sum_m3 += volume_m3(snag, species());
    }
    for (const Log& log : wood.logs) {
        sum_m3 += volume_m3(log, species());
    }
    return sum_m3 / grid.area_ha();
}

TEST(DeadWoodFromRecords, HasTheVolumeOfTheRecordToOnePiece) {
    const PatchGrid grid = square_of_forest(10);
    for (const DeadWoodKind kind : {DeadWoodKind::snag, DeadWoodKind::stump, DeadWoodKind::log}) {
        DeadWoodRecord record{.kind = kind, .volume_m3pha = 25.0, .dbh_cm = 30.0};
        record.length_m = kind == DeadWoodKind::stump ? 0.5 : 8.0;
        const std::vector stands{on_all(grid, record)};
        const SnagsAndLogs wood = dead_wood_from_records(stands, grid, species(), 2020, 1, 0);
        const std::size_t pieces = wood.snags.size() + wood.logs.size();
        ASSERT_GT(pieces, 20U);
        EXPECT_EQ(wood.logs.empty(), kind != DeadWoodKind::log);
        EXPECT_NEAR(volume_m3pha(wood, grid), 25.0, 25.0 / static_cast<double>(pieces));
        for (const Snag& snag : wood.snags) {
            EXPECT_EQ(snag.cut, kind == DeadWoodKind::stump);
            EXPECT_TRUE(grid.at(snag.x_m, snag.y_m));
        }
    }
}

TEST(DeadWoodFromRecords, HasTheVolumeOfTheRecordInTheMeanOfReplicates) {
    // Less than a piece in each replicate.
    const PatchGrid grid = square_of_forest(2);
    const std::vector stands{on_all(grid, {.kind = DeadWoodKind::log, .volume_m3pha = 5.0, .dbh_cm = 40.0})};
    constexpr int replicates = 4000;
    double sum = 0.0;
    std::size_t pieces = 0;
    for (std::uint32_t r = 0; r < replicates; ++r) {
        const SnagsAndLogs wood = dead_wood_from_records(stands, grid, species(), 2020, 1, r);
        sum += volume_m3pha(wood, grid);
        pieces += wood.logs.size();
    }
    const double share = static_cast<double>(pieces) / replicates;
    ASSERT_LT(share, 1.0);
    const double piece_m3pha = sum / static_cast<double>(pieces);
    EXPECT_NEAR(sum / replicates, 5.0, 4.0 * piece_m3pha * std::sqrt(share * (1.0 - share) / replicates));
}

TEST(DeadWoodFromRecords, LiesAtTheAngleOfTheRecordToTheFallLine) {
    const PatchGrid grid = square_of_forest(10);
    DeadWoodRecord record{.kind = DeadWoodKind::log, .volume_m3pha = 40.0, .dbh_cm = 30.0};
    record.to_fall_line_deg = 70.0;
    const double down_rad = fall_line_of(grid.patches().front()).in_radians();
    int left = 0;
    const std::vector stands{on_all(grid, record)};
    const SnagsAndLogs wood = dead_wood_from_records(stands, grid, species(), 2020, 1, 0);
    for (const Log& log : wood.logs) {
        const double turn_deg = (log.direction_rad - down_rad) * 180.0 / M_PI;
        EXPECT_NEAR(std::abs(turn_deg), 70.0, 1e-6);
        left += turn_deg > 0.0 ? 1 : 0;
    }
    const auto n = static_cast<double>(wood.logs.size());
    EXPECT_NEAR(left, 0.5 * n, 4.0 * 0.5 * std::sqrt(n)) << "either way";
}

TEST(DeadWoodFromRecords, IsOlderAndLighterInHigherDecayClasses) {
    const PatchGrid grid = square_of_forest(4);
    double density_before = 1.1;
    int year_before = 2021;
    for (int decay_class = 1; decay_class <= 5; ++decay_class) {
        const std::vector stands{on_all(
            grid,
            {.kind = DeadWoodKind::snag, .volume_m3pha = 60.0, .dbh_cm = 25.0, .decay_class = decay_class})};
        const SnagsAndLogs wood = dead_wood_from_records(stands, grid, species(), 2020, 1, 0);
        ASSERT_FALSE(wood.snags.empty());
        EXPECT_LT(wood.snags[0].density_share, density_before);
        EXPECT_LT(wood.snags[0].year, year_before);
        density_before = wood.snags[0].density_share;
        year_before = wood.snags[0].year;
    }
}

TEST(CohortsFromRecords, HaveTheStemsOfTheRecord) {
    const PatchGrid grid = square_of_forest(20);
    OnPatches<SaplingRecord> stand{
        .records = {{.species = *species().find("abal"), .stems_pha = 1230.0, .height_m = 0.4}}};
    for (std::uint32_t i = 0; i < grid.size(); ++i) {
        stand.patches.push_back(PatchId{i});
    }
    double stems = 0.0;
    for (const Cohort& cohort : cohorts_from_records(std::vector{stand}, 1, 0)) {
        EXPECT_EQ(cohort.height_m, 0.4);
        stems += cohort.stems;
    }
    // 12.3 a patch: 12 or 13.
    const double patches = 400.0;
    EXPECT_NEAR(stems, 1230.0 * 4.0, 4.0 * std::sqrt(patches * 0.3 * 0.7));
}

TEST(Stand, BeginsWithDeadWoodThatIsNoGain) {
    const PatchGrid grid = square_of_forest(4);
    const std::vector stands{on_all(grid, {.kind = DeadWoodKind::log, .volume_m3pha = 50.0})};
    Stand stand{grid, species().size(), {}, 2020};
    stand.begin_with(dead_wood_from_records(stands, grid, species(), 2020, 1, 0));
    EXPECT_GT(stand.dead_wood_kg(), 0.0);
    EXPECT_EQ(stand.dead_wood_at_start_kg(), stand.dead_wood_kg());
    EXPECT_EQ(stand.balance().dead_wood_in_kg, 0.0);
}

}  // namespace
}  // namespace forest::starting_dead_wood_test
