#include "coupling/run/watched_falls.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/rockfall/slopes.hpp"

namespace coupling::watched_falls_test {
namespace {

using rockfall::Cover;

/// A forested slope with a road below; some of the rocks have their place beyond the border.
struct Scene {
    rockfall::Slope slope = rockfall::testing::plane_slope(35.0, {0.30, 0.80}, 0.01, 400.0, 200.0);
    rockfall::StemIndex stems{random_stems(), slope.terrain, 0.5, true};
    std::vector<rockfall::ReleaseSource> sources;
    std::vector<rockfall::Target> targets;
    rockfall::Assessment assessment;

    explicit Scene(std::uint64_t rocks)
        : sources{two_sources(rocks)}, targets{road()}, assessment{slope,       stems, sources, targets,
                                                                   start_law(), law(), frame(), 42} {
        assessment.path_every = 100;
    }

    static std::vector<rockfall::Stem> random_stems() {
        std::vector<rockfall::Stem> stems;
        for (std::size_t i = 0; i < 800; ++i) {
            config::RandomStream stream{{3, 0, 0, i}, config::Purpose::test};
            stems.push_back({60.0 + 200.0 * stream.uniform(), 200.0 * stream.uniform(), 35.0, 20.0, 1.0});
        }
        return stems;
    }
    std::vector<rockfall::ReleaseSource> two_sources(std::uint64_t rocks) const {
        std::vector<rockfall::ReleaseSource> both(2);
        both[0].first_m = Eigen::Vector2d{20.0, 80.0} - slope.terrain.origin_m();
        both[0].last_m = both[0].first_m + Eigen::Vector2d{10.0, 40.0};
        both[1] = both[0];
        both[1].kind = rockfall::ReleaseSource::Kind::line;
        both[1].first_m.x() -= 1000.0;
        both[1].last_m = both[1].first_m;
        both[1].weight = 0.1;  // few rocks, none of which starts
        rockfall::allot(both, rocks);
        return both;
    }
    std::vector<rockfall::Target> road() const {
        rockfall::Target line;
        const Eigen::Vector2d o = slope.terrain.origin_m();
        line.parts = {{Eigen::Vector2d{300.0, 2.0} - o, Eigen::Vector2d{300.0, 198.0} - o}};
        return {rockfall::with_bounds(line)};
    }
    config::GridFrame frame() const {
        return {40, 20, -slope.terrain.origin_m().x(), -slope.terrain.origin_m().y(), 10.0, 10.0};
    }
    static rockfall::StartLaw start_law() {
        rockfall::StartLaw law;
        law.diameter = rockfall::DiameterLaw::uniform(0.4, 1.0);
        return law;
    }
    static rockfall::FallLaw law() {
        rockfall::FallLaw law;
        law.tree.deviation = rockfall::testing::deterministic_law().tree.deviation;
        return law;
    }
};

std::vector<WatchedFall> falls_of(const Scene& scene, Cover cover, int threads) {
    std::vector<WatchedFall> falls;
    EXPECT_EQ(watch_falls(scene.assessment, cover, threads,
                          [&](const WatchedFall& fall) { falls.push_back(fall); }),
              Ended::done);
    return falls;
}

void expect_same(const rockfall::RockRecord& a, const rockfall::RockRecord& b) {
    EXPECT_EQ(a.rock, b.rock);
    EXPECT_EQ(a.source, b.source);
    EXPECT_EQ(a.reason, b.reason);
    EXPECT_EQ(a.diameter_m, b.diameter_m);
    EXPECT_EQ(a.start_m, b.start_m);
    EXPECT_EQ(a.end_m, b.end_m);
    EXPECT_EQ(a.path_m, b.path_m);
    EXPECT_EQ(a.time_s, b.time_s);
    EXPECT_EQ(a.max_speed_mps, b.max_speed_mps);
    EXPECT_EQ(a.max_energy_j, b.max_energy_j);
    EXPECT_EQ(a.max_height_m, b.max_height_m);
    EXPECT_EQ(a.jump_height_sum_m, b.jump_height_sum_m);
    EXPECT_EQ(a.jumps, b.jumps);
    EXPECT_EQ(a.ground_impacts, b.ground_impacts);
    EXPECT_EQ(a.tree_hits, b.tree_hits);
    EXPECT_EQ(a.tree_energy_j, b.tree_energy_j);
}

TEST(WatchFalls, GivesTheSameFallsOnAnyNumberOfThreads) {
    const Scene scene{1000};
    const auto one = falls_of(scene, Cover::forest, 1);
    for (const int threads : {2, 7}) {
        const auto many = falls_of(scene, Cover::forest, threads);
        ASSERT_EQ(many.size(), one.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            ASSERT_EQ(many[i].started, one[i].started);
            expect_same(many[i].record, one[i].record);
            ASSERT_EQ(many[i].jumps.size(), one[i].jumps.size());
            for (std::size_t k = 0; k < one[i].jumps.size(); ++k) {
                EXPECT_EQ(many[i].jumps[k].from_m, one[i].jumps[k].from_m);
                EXPECT_EQ(many[i].jumps[k].to_m, one[i].jumps[k].to_m);
                EXPECT_EQ(many[i].jumps[k].landed, one[i].jumps[k].landed);
            }
            EXPECT_EQ(many[i].path.size(), one[i].path.size());
        }
    }
}

TEST(WatchFalls, ComesInRockOrderAndSaysWhichRocksDidNotStart) {
    const Scene scene{1000};
    const auto falls = falls_of(scene, Cover::bare, 3);
    ASSERT_EQ(falls.size(), 1000U);
    std::size_t not_started = 0;
    for (std::size_t i = 0; i < falls.size(); ++i) {
        const bool in_first = i < scene.sources[1].first_rock;
        EXPECT_EQ(falls[i].started, in_first) << i;
        if (falls[i].started) {
            EXPECT_EQ(falls[i].record.rock, i);
            EXPECT_EQ(falls[i].record.jumps, falls[i].jumps.size());
            EXPECT_EQ(falls[i].path.empty(), i % 100 != 0);
        } else {
            ++not_started;
            EXPECT_TRUE(falls[i].jumps.empty() && falls[i].arrivals.empty() && falls[i].path.empty());
            EXPECT_EQ(falls[i].record.ground_impacts, 0U);
        }
    }
    EXPECT_EQ(not_started, scene.sources[1].rocks);
    EXPECT_GT(not_started, 50U);
}

TEST(WatchFalls, AgreesWithTheWorkerOfOrdinaryRuns) {
    const Scene scene{1000};
    rockfall::Worker worker{scene.assessment, {nullptr, nullptr}};
    rockfall::ChunkRows rows;
    for (const rockfall::Chunk& chunk : rockfall::plan_chunks(scene.sources)) {
        worker.run(chunk, rows, nullptr, {});
    }
    for (const Cover cover : {Cover::forest, Cover::bare}) {
        const auto c = static_cast<std::size_t>(cover);
        std::size_t row = 0;
        std::size_t reached = 0;
        for (const WatchedFall& fall : falls_of(scene, cover, 2)) {
            if (!fall.started) {
                continue;
            }
            ASSERT_LT(row, rows.rocks[c].size());
            expect_same(fall.record, rows.rocks[c][row]);
            ASSERT_EQ(fall.arrivals.size(), 1U);
            const auto arrived =
                std::find_if(rows.arrivals[c].begin(), rows.arrivals[c].end(),
                             [&](const auto& a) { return a.rock == rows.rocks[c][row].rock; });
            ASSERT_EQ(fall.arrivals[0].reached, arrived != rows.arrivals[c].end());
            if (fall.arrivals[0].reached) {
                EXPECT_EQ(fall.arrivals[0].energy_j, arrived->arrival.energy_j);
            }
            EXPECT_EQ(fall.tree_hits.size(), fall.record.tree_hits);
            reached += fall.arrivals[0].reached ? 1 : 0;
            ++row;
        }
        EXPECT_EQ(row, rows.rocks[c].size());
        EXPECT_GT(reached, 10U);
    }
}

TEST(WatchFalls, PassesOnWhatTheSinkThrows) {
    const Scene scene{1000};
    std::size_t seen = 0;
    EXPECT_THROW((void)watch_falls(scene.assessment, Cover::bare, 2,
                                   [&](const WatchedFall&) {
                                       if (++seen == 100) {
                                           throw std::runtime_error{"the disk is full"};
                                       }
                                   }),
                 std::runtime_error);
    EXPECT_EQ(seen, 100U);  // nothing comes after the first error
}

}  // namespace
}  // namespace coupling::watched_falls_test
