#include "rockfall/one_slope.hpp"

#include <gtest/gtest.h>

#include "tests/rockfall/ensemble_scene.hpp"

namespace rockfall::one_slope_test {
namespace {

using testing::same_but_for_marks;
using testing::Scene;
using testing::tally_of;

TEST(OneSlopeWorker, CountsWhatAWorkerCountsOnThatSlope) {
    // Of every model, as a worker lets a rock that meets nothing in the forest fall but once. No block has a
    // shape here.
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

}  // namespace
}  // namespace rockfall::one_slope_test
