#include "coupling/exchange/stopping_places.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "coupling/exchange/yearly_rockfall.hpp"
#include "tests/coupling/inputs/forest_project.hpp"

namespace coupling::exchange::stopping_places_test {
namespace {

constexpr auto with_forest = static_cast<std::size_t>(rockfall::Cover::forest);

/// A slope that falls eastward from x = 0 to a road at x = 100, with patches on it from x = 20 to 100.
class EvenSlope {
public:
    EvenSlope() {
        road_.parts = {{{100.0, -1000.0}, {100.0, 1000.0}}};
        distances_.emplace_back(road_);
        bare_.targets.resize(1);
        bare_.arrived.resize(4);
    }

    /// A rock that falls straight east from x = 0 and hits trees at these places.
    void falls(double y_m, const std::vector<double>& trees_x_m, double end_x_m, bool arrives_bare) {
        const std::uint64_t rock = rows_.rocks[with_forest].size();
        rockfall::RockRecord& fall = rows_.rocks[with_forest].emplace_back();
        fall.rock = rock;
        fall.start_m = {0.0, y_m, 0.0};
        fall.end_m = {end_x_m, y_m, 0.0};
        for (const double x_m : trees_x_m) {
            rockfall::TreeHitRecord hit{};
            hit.stem = static_cast<std::uint32_t>(stems_.size());
            hit.position_m = {x_m, y_m, 0.0};
            rockfall::PlacedStem stem{};
            stem.x_m = x_m;
            stem.y_m = y_m;
            stems_.push_back(stem);
            rows_.tree_hits.emplace_back(rock, hit);
        }
        if (end_x_m >= 100.0) {
            rockfall::ArrivalRecord arrival{rock, 0, {}};
            arrival.arrival.x_m = 100.0F;
            arrival.arrival.y_m = static_cast<float>(y_m);
            rows_.arrivals[with_forest].push_back(arrival);
        }
        if (arrives_bare) {
            bare_.arrived[rock / 64] |= std::uint64_t{1} << (rock % 64);
        }
    }

    rockfall::ChunkRows& rows() { return rows_; }

    [[nodiscard]] StoppingPlaces count() const {
        StoppingPlaceCounter counter{distances_, grid_, {0.0, 0.0}, stems_};
        counter.add(rows_, bare_);
        return counter.take();
    }

    [[nodiscard]] const PlaceCounts& patch_at(const StoppingPlaces& places, double x_m, double y_m) const {
        return places.patches[forest::index_of(grid_.at(x_m, y_m).value())];
    }

private:
    static forest::PatchGrid patches() {
        std::vector<forest::Patch> all;
        for (int row = 0; row < 10; ++row) {
            for (int column = 2; column < 12; ++column) {
                all.emplace_back().cell = {column, row};
            }
        }
        return {config::GridFrame{12, 10, 0.0, 0.0, forest::patch_side_m, forest::patch_side_m}, all};
    }

    rockfall::Target road_;
    std::vector<rockfall::TargetDistance> distances_;
    forest::PatchGrid grid_ = patches();
    std::vector<rockfall::PlacedStem> stems_;
    rockfall::ChunkRows rows_;
    BareYear bare_;
};

TEST(StoppingPlaces, CreditASparedRockToItsLastTree) {
    EvenSlope slope;
    slope.falls(5.0, {35.0, 77.0}, 78.0, true);
    const StoppingPlaces places = slope.count();
    ASSERT_EQ(places.bands.front().size(), 11U);
    for (std::size_t band = 0; band < 11; ++band) {
        EXPECT_EQ(places.bands.front()[band].spared, band == 2 ? 1 : 0) << band;
    }
    EXPECT_EQ(slope.patch_at(places, 77.0, 5.0).spared, 1);
    EXPECT_EQ(slope.patch_at(places, 35.0, 5.0).spared, 0);
    EXPECT_EQ(places.without_tree.front(), 0);
}

TEST(StoppingPlaces, TakeAwayForARockThatTheForestMakesArrive) {
    EvenSlope slope;
    slope.falls(5.0, {35.0, 77.0, 104.0}, 110.0, false);  // the tree below the road is not the cause
    const StoppingPlaces places = slope.count();
    EXPECT_EQ(places.bands.front()[2].spared, -1);
    EXPECT_EQ(places.bands.front()[2].came, 0U);  // no rock of this target over the bare slope
    EXPECT_EQ(slope.patch_at(places, 77.0, 5.0).spared, -1);
}

TEST(StoppingPlaces, LeaveOutWhatArrivesBothWaysOrNeverDoes) {
    EvenSlope slope;
    slope.falls(5.0, {35.0}, 110.0, true);
    slope.falls(15.0, {35.0}, 36.0, false);
    const StoppingPlaces places = slope.count();
    for (const PlaceCounts& band : places.bands.front()) {
        EXPECT_EQ(band.spared, 0);
        EXPECT_LE(band.came, 1U);
    }
    EXPECT_EQ(places.bands.front()[6].came, 1U);
}

TEST(StoppingPlaces, ShowRocksThatMetNoTree) {
    EvenSlope slope;
    slope.falls(5.0, {}, 60.0, true);
    const StoppingPlaces places = slope.count();
    EXPECT_EQ(places.without_tree.front(), 1);
    EXPECT_EQ(places.patches.back().spared, 1);
    for (const PlaceCounts& band : places.bands.front()) {
        EXPECT_EQ(band.spared, 0);
    }
}

TEST(StoppingPlaces, GiveARockThatLeansOnATreeToWhereItLies) {
    EvenSlope slope;
    slope.falls(5.0, {35.0}, 61.0, true);
    slope.rows().rocks[with_forest].front().reason = rockfall::StopReason::tree;
    EXPECT_EQ(slope.count().bands.front()[3].spared, 1);
}

TEST(StoppingPlaces, TakeTheLaterOfTreeAndLog) {
    for (const double log_x_m : {50.0, 90.0}) {
        EvenSlope slope;
        slope.falls(5.0, {72.0}, 91.0, true);
        rockfall::LogHitRecord hit{};
        hit.position_m = {log_x_m, 5.0, 0.0};
        slope.rows().log_hits.emplace_back(0, hit);
        const StoppingPlaces places = slope.count();
        EXPECT_EQ(places.bands.front()[log_x_m < 72.0 ? 2 : 1].spared, 1) << log_x_m;
    }
}

TEST(StoppingPlaces, FollowARockThroughItsBands) {
    EvenSlope slope;
    slope.falls(5.0, {}, 110.0, true);       // meets nothing, arrives
    slope.falls(15.0, {77.0}, 110.0, true);  // meets a tree in band 2, and arrives
    slope.falls(25.0, {}, 71.0, true);       // ends in band 2
    slope.falls(35.0, {71.0, 79.0}, 79.0, true);
    slope.falls(45.0, {35.0}, 36.0, true);  // does not come so far
    const PlaceCounts band = slope.count().bands.front()[2];
    EXPECT_EQ(band.came, 4U);
    EXPECT_EQ(band.met, 2U);
    EXPECT_EQ(band.missed, 1U);
    EXPECT_EQ(band.missed_arrived, 1U);
    EXPECT_EQ(band.spared, 1);
    const PlaceCounts above = slope.count().bands.front()[3];
    EXPECT_EQ(above.came, 4U);
    EXPECT_EQ(above.missed, 4U);
    EXPECT_EQ(above.missed_arrived, 2U);
}

TEST(StoppingPlaces, FollowARockThroughItsPatches) {
    EvenSlope slope;
    slope.falls(5.0, {77.0}, 110.0, true);
    slope.falls(5.0, {}, 64.0, true);
    const StoppingPlaces places = slope.count();
    for (double x_m = 25.0; x_m < 100.0; x_m += 10.0) {
        const PlaceCounts& patch = slope.patch_at(places, x_m, 5.0);
        EXPECT_EQ(patch.came, x_m < 70.0 ? 2U : 1U) << x_m;
        EXPECT_EQ(patch.met, x_m == 75.0 ? 1U : 0U) << x_m;
        EXPECT_EQ(patch.missed, x_m < 60.0 ? 2U : x_m == 75.0 ? 0U : 1U) << x_m;
        EXPECT_EQ(patch.missed_arrived, x_m == 75.0 ? 0U : 1U) << x_m;
        EXPECT_EQ(slope.patch_at(places, x_m, 15.0), PlaceCounts{});
    }
    EXPECT_EQ(slope.patch_at(places, 105.0, 5.0), PlaceCounts{});  // beyond the road
}

/// Rocks through forests of records.
struct RecordedForest {
    explicit RecordedForest(std::vector<std::string> settings)
        : opened{open(project, with_stands(settings))} {
        if (!opened.site) {
            throw std::runtime_error{opened.errors};
        }
        rocks.emplace(*opened.scenario, *opened.site, opened.site->forest->species.fracture_energy,
                      std::vector<rockfall::Stem>{});
    }
    static std::vector<std::string> with_stands(std::vector<std::string> settings) {
        settings.insert(settings.begin(), {"trees.file=", "stands.records=records.csv", "release.rocks=300"});
        return settings;
    }
    [[nodiscard]] YearFalls fall(const forest::Stand& stand, std::int32_t year, int threads = 1) const {
        return rocks->simulate(stand, rocks->simulate_bare(0, year, false, 1), 0, false, threads);
    }

    ForestProject project;
    Opened opened;
    std::optional<YearlyRockfall> rocks;
};

void expect_whole_books(const YearFalls& falls) {
    const auto bare = static_cast<std::size_t>(rockfall::Cover::bare);
    std::int64_t all_targets = 0;
    for (std::size_t target = 0; target < falls.tally.targets.size(); ++target) {
        const rockfall::TargetTally& tally = falls.tally.targets[target];
        std::int64_t spared = falls.stopping.without_tree[target];
        for (const PlaceCounts& band : falls.stopping.bands[target]) {
            spared += band.spared;
            EXPECT_GE(band.came, band.met + band.missed);
            EXPECT_GE(band.missed, band.missed_arrived);
        }
        const auto difference = static_cast<std::int64_t>(tally.by_cover[bare].reached) -
                                static_cast<std::int64_t>(tally.by_cover[with_forest].reached);
        EXPECT_EQ(spared, difference) << target;
        all_targets += difference;
    }
    std::int64_t spared = 0;
    for (const PlaceCounts& patch : falls.stopping.patches) {
        spared += patch.spared;
    }
    EXPECT_EQ(spared, all_targets);
}

TEST(StoppingPlaces, SumUpToTheRocksSparedInAnyForest) {
    bool any = false;
    for (const char* diameter : {"0.3", "0.8", "2"}) {
        const RecordedForest forest{{std::string{"release.diameter_m="} + diameter}};
        for (const std::int32_t year : {1, 2, 3}) {
            const forest::Stand stand =
                forest.opened.site->forest->start(static_cast<std::uint64_t>(year), 0);
            const YearFalls falls = forest.fall(stand, year);
            ASSERT_TRUE(falls.with_forest);
            expect_whole_books(falls);
            any = any || falls.stopping.patches != std::vector<PlaceCounts>(falls.stopping.patches.size());
        }
    }
    EXPECT_TRUE(any);
}

TEST(StoppingPlaces, AreTheSameForAnyNumberOfThreads) {
    const RecordedForest forest{{"release.rocks=2000"}};
    const forest::Stand stand = forest.opened.site->forest->start(1, 0);
    const StoppingPlaces one = forest.fall(stand, 1, 1).stopping;
    const StoppingPlaces four = forest.fall(stand, 1, 4).stopping;
    EXPECT_EQ(one.bands, four.bands);
    EXPECT_EQ(one.patches, four.patches);
    EXPECT_EQ(one.without_tree, four.without_tree);
}

TEST(StoppingPlaces, AreNoneWithoutAForest) {
    const RecordedForest forest{{}};
    const ForestSite& site = *forest.opened.site->forest;
    const YearFalls falls = forest.fall({site.grid, site.species.table.size(), {}, site.first_year() - 1}, 1);
    for (const auto& bands : falls.stopping.bands) {
        EXPECT_TRUE(bands.empty());
    }
    EXPECT_EQ(falls.stopping.patches, std::vector<PlaceCounts>(site.grid.size() + 1));
}

TEST(StoppingPlaces, LieWhereTheOnlyTreesStand) {
    // Trees in one row of patches across the slope alone: all credit is there, and what is met.
    const RecordedForest forest{{}};
    const ForestSite& site = *forest.opened.site->forest;
    const forest::Stand full = site.start(1, 0);
    std::vector<forest::Tree> kept;
    for (const forest::Tree& tree : full.trees()) {
        if (tree.x_m >= 1070.0 && tree.x_m < 1080.0) {
            kept.push_back(tree);
        }
    }
    ASSERT_GT(kept.size(), 20U);
    const forest::Stand strip{site.grid, site.species.table.size(), kept, site.first_year() - 1};
    const YearFalls falls = forest.fall(strip, 1);
    expect_whole_books(falls);
    std::int64_t spared = 0;
    for (std::size_t patch = 0; patch < site.grid.size(); ++patch) {
        const PlaceCounts& counts = falls.stopping.patches[patch];
        const double x_m = site.grid.x_centre_m(static_cast<forest::PatchId>(patch));
        if (x_m < 1070.0 || x_m > 1080.0) {
            EXPECT_EQ(counts.spared, 0) << x_m;
            EXPECT_EQ(counts.met, 0U) << x_m;
        }
        spared += counts.spared;
    }
    EXPECT_NE(spared, 0);
}

}  // namespace
}  // namespace coupling::exchange::stopping_places_test
