#include "rockfall/one_slope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/rockfall/ensemble_scene.hpp"

namespace rockfall::one_slope_test {
namespace {

using testing::same_but_for_marks;
using testing::Scene;
using testing::tally_of;

TEST(OneSlopeWorker, CountsWhatAWorkerCountsOnThatSlope) {
    // Of every model whose rocks are many. No block has a shape here.
    for (const MotionModel model :
         {motion_model<picus::Model>, motion_model<pir3d::Model>, motion_model<classical::Model>}) {
        Scene scene{2000};
        scene.assessment.law.motion.model = model;
        const std::vector<Chunk> chunks = plan_chunks(scene.sources, 150);
        const EnsembleTally both = tally_of(scene, chunks, 1);
        for (const Cover cover : {Cover::forest, Cover::bare}) {
            OneSlopeWorker worker{scene.assessment, cover};
            FedCells fed{scene.assessment.map_frame.size()};
            ChunkRows rows;
            for (const Chunk& chunk : chunks) {
                worker.run(chunk, rows, chunk.whole_sources ? nullptr : &fed);
            }
            const auto c = static_cast<std::size_t>(cover);
            EXPECT_TRUE(same_but_for_marks(worker.tally().cells[c], both.cells[c]));
            EXPECT_EQ(worker.tally().runs[c].run_out_sum_mm, both.runs[c].run_out_sum_mm);
            EXPECT_EQ(worker.tally().runs[c].max_energy, both.runs[c].max_energy);
            EXPECT_EQ(worker.tally().targets[0].by_cover[c].energy, both.targets[0].by_cover[c].energy);
            EXPECT_EQ(rows.rocks[c].size(), both.runs[c].rocks);
            EXPECT_EQ(worker.tally().runs[1 - c].rocks, 0U);
            EXPECT_EQ(rows.tree_hits.empty(), cover == Cover::bare);
        }
    }
}

/// Nets above, within and below the stand, of which some rocks pass over, below or through each.
std::vector<Net> some_nets(const Scene& scene) {
    const Eigen::Vector2d o = scene.slope.terrain.origin_m();
    std::vector<Net> nets;
    for (const double x_m : {60.0, 180.0, 310.0}) {
        nets.push_back(
            {{Eigen::Vector2d{x_m, 2.0} - o, Eigen::Vector2d{x_m + 3.0, 198.0} - o}, 1.5, 0.5, 5e4});
    }
    return nets;
}

std::vector<Log> some_logs() {
    std::vector<Log> logs;
    for (std::size_t i = 0; i < 60; ++i) {
        const config::RandomStream stream{{5, 0, 0, i}, config::Purpose::test};
        const auto u = stream.uniforms_of(0);
        const double x_m = 80.0 + 200.0 * u[0], y_m = 10.0 + 170.0 * u[1];
        logs.push_back({.x1_m = x_m,
                        .y1_m = y_m,
                        .x2_m = x_m + 4.0,
                        .y2_m = y_m + 10.0 * u[2],
                        .diameter1_cm = 40.0,
                        .diameter2_cm = 30.0});
    }
    return logs;
}

/// The rows of a chunk over one slope.
auto rows_of(const ChunkRows& rows, Cover cover) {
    const auto c = static_cast<std::size_t>(cover);
    std::vector<std::vector<double>> all;
    for (const RockRecord& r : rows.rocks[c]) {
        all.push_back({static_cast<double>(r.rock),
                       static_cast<double>(r.reason),
                       static_cast<double>(r.left_over),
                       r.start_m.x(),
                       r.end_m.x(),
                       r.end_m.y(),
                       r.end_m.z(),
                       r.path_m,
                       r.time_s,
                       r.max_speed_mps,
                       r.min_speed_mps,
                       r.max_energy_j,
                       r.max_height_m,
                       r.jump_height_sum_m,
                       static_cast<double>(r.jumps),
                       static_cast<double>(r.long_jumps),
                       r.jump_length_sum_m,
                       r.min_jump_length_m,
                       r.max_jump_length_m,
                       static_cast<double>(r.ground_impacts),
                       static_cast<double>(r.tree_hits),
                       r.tree_energy_j,
                       static_cast<double>(r.log_hits),
                       r.log_energy_j,
                       r.dissipated_j,
                       r.residual_j,
                       r.corrected_j});
        for (const GroundCount& on : r.impacts_by_ground) {
            all.back().push_back(on.impacts);
        }
    }
    for (const ArrivalRecord& a : rows.arrivals[c]) {
        all.push_back({static_cast<double>(a.rock), static_cast<double>(a.target), a.arrival.x_m,
                       a.arrival.y_m, a.arrival.energy_j, a.arrival.top_height_m});
    }
    for (const auto& [rock, n] : rows.net_crossings[c]) {
        all.push_back({static_cast<double>(rock), static_cast<double>(n.net), n.x_m, n.y_m, n.along_m,
                       n.height_m, n.energy_j, n.speed_mps, static_cast<double>(n.outcome),
                       n.first ? 1.0 : 0.0});
    }
    for (const PathRecord& path : rows.paths) {
        for (const PathPoint& p : path.points) {
            if (path.cover == cover) {
                all.push_back({static_cast<double>(path.rock), p.position_m.x(), p.position_m.y(),
                               p.position_m.z(), p.energy_j, p.height_m, p.attitude[0], p.attitude[3]});
            }
        }
    }
    return all;
}

TEST(OneSlopeWorker, HandsOverTheRowsOfAWorkerPastNetsStemsAndLogs) {
    // A worker simulates what is common to both falls once. Each must be as if it had fallen alone.
    for (const MotionModel model : all_models()) {
        Scene scene{rocks_of_chunk(model) > 100 ? 600U : 12U};
        scene.assessment.law.motion.model = model;
        scene.assessment.path_every = 1;
        const NetIndex nets{some_nets(scene)};
        const LogIndex logs{some_logs(), scene.slope.terrain, 0.5, 0.5};
        for (const bool with_works : {false, true}) {
            SCOPED_TRACE(std::string{description_of(model).name} + (with_works ? ", nets and logs" : ""));
            scene.assessment.nets = with_works ? &nets : nullptr;
            scene.assessment.logs = with_works ? &logs : nullptr;
            const Chunk all = {0,    20,   0, scene.sources.back().first_rock + scene.sources.back().rocks,
                               true, false};
            ChunkRows both;
            Worker worker{scene.assessment, {nullptr, nullptr}};
            worker.run(all, both, nullptr, {});
            EXPECT_GT(worker.tally().runs[static_cast<std::size_t>(Cover::forest)].hits, 10U);
            for (const Cover cover : {Cover::forest, Cover::bare}) {
                ChunkRows alone;
                OneSlopeWorker single{scene.assessment, cover};
                single.run(all, alone, nullptr);
                const auto c = static_cast<std::size_t>(cover);
                EXPECT_TRUE(rows_of(alone, cover) == rows_of(both, cover));
                EXPECT_TRUE(same_but_for_marks(single.tally().cells[c], worker.tally().cells[c]));
            }
        }
    }
}

TEST(Worker, FallsOverTheBareSlopeWhateverBrokeInTheForest) {
    Scene scene{600};
    scene.assessment.law.tree.remove_broken = true;
    const Chunk all = {0, 20, 0, 600, true, false};
    std::vector<std::uint8_t> gone(scene.stems.size());
    ChunkRows both;
    Worker worker{scene.assessment, {nullptr, nullptr}};
    worker.run(all, both, nullptr, gone);
    EXPECT_GT(std::count(gone.begin(), gone.end(), 1), 10);
    ChunkRows alone;
    OneSlopeWorker single{scene.assessment, Cover::bare};
    single.run(all, alone, nullptr);
    EXPECT_TRUE(rows_of(alone, Cover::bare) == rows_of(both, Cover::bare));
}

}  // namespace
}  // namespace rockfall::one_slope_test
