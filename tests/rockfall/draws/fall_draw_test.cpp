#include "rockfall/draws/fall_draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "rockfall/ensemble.hpp"
#include "tests/rockfall/ensemble_scene.hpp"

namespace rockfall::fall_draw_test {
namespace {

using testing::same_but_for_marks;
using testing::Scene;
using testing::tally_of;

std::vector<FallDraw> draws_with(const Scene& scene, const FallFactors& factors, std::size_t strata = 16) {
    const std::vector<double> own(scene.slope.types.size(), 1.0);
    return std::vector<FallDraw>(strata, draw_of(scene.assessment.law, scene.slope.types, factors, own));
}

EnsembleTally fall_with(Scene& scene, const FallFactors& factors) {
    const std::vector<FallDraw> draws = draws_with(scene, factors);
    scene.assessment.draws = draws;
    EnsembleTally tally = tally_of(scene, plan_chunks(scene.sources, 150), 2);
    scene.assessment.draws = {};
    return tally;
}

TEST(FallDraw, OfFactorsOfOneChangesNoBitUnderAnyModel) {
    for (const MotionModel model : {motion_model<picus::Model>, motion_model<pir3d::Model>,
                                    motion_model<classical::Model>, motion_model<rigid::Model>}) {
        const std::uint64_t rocks = description_of(model).has_shape ? 20 : 500;
        Scene scene{rocks};
        scene.assessment.law.motion.model = model;
        const EnsembleTally plain = tally_of(scene, plan_chunks(scene.sources, 150), 1);
        const EnsembleTally drawn = fall_with(scene, {});
        for (std::size_t c = 0; c < covers; ++c) {
            EXPECT_TRUE(same_but_for_marks(plain.cells[c], drawn.cells[c]));
            EXPECT_EQ(plain.runs[c].run_out_sum_mm, drawn.runs[c].run_out_sum_mm);
            EXPECT_EQ(plain.runs[c].max_energy, drawn.runs[c].max_energy);
        }
        EXPECT_TRUE(plain.strata.empty());
        EXPECT_EQ(drawn.strata.size(), 16U);
    }
}

TEST(FallDraw, StopsRocksSoonerWhereGroundTakesMore) {
    Scene scene{1000};
    const auto reached = [&](const FallFactors& factors) {
        return fall_with(scene, factors).targets[0].by_cover[static_cast<std::size_t>(Cover::bare)].reached;
    };
    const std::uint64_t usual = reached({});
    EXPECT_GT(usual, 100U);
    EXPECT_LT(reached({.losses = 1.5}), usual);
    EXPECT_GT(reached({.losses = 0.6}), usual);
    EXPECT_LT(reached({.stopping = 3.0}), usual);
    EXPECT_GT(reached({.stopping = 0.2}), usual);
}

TEST(FallDraw, ChangesNothingOnTheBareSlopeWhereOnlyTreesDiffer) {
    Scene scene{1000};
    const EnsembleTally usual = fall_with(scene, {});
    const EnsembleTally strong = fall_with(scene, {.tree_energy = 2.0});
    const auto forest = static_cast<std::size_t>(Cover::forest);
    const auto bare = static_cast<std::size_t>(Cover::bare);
    EXPECT_TRUE(same_but_for_marks(usual.cells[bare], strong.cells[bare]));
    EXPECT_LT(strong.targets[0].by_cover[forest].reached, usual.targets[0].by_cover[forest].reached);
}

TEST(FallDraw, GivesGroundAShareOfTheLossesOfItsOwn) {
    SurfaceType type;
    type.restitution = {0.3, 0.8};
    type.rolling_friction = 0.4;
    const std::vector<SurfaceType> types{type, type};
    const FallDraw draw = draw_of({}, types, {.losses = 0.5, .friction = 1.2}, std::vector<double>{1.0, 3.0});
    EXPECT_DOUBLE_EQ(draw.types[0].restitution.tangential, 0.9);
    EXPECT_DOUBLE_EQ(draw.types[1].restitution.tangential, 0.7);
    EXPECT_DOUBLE_EQ(draw.types[1].restitution.normal, 0.3);
    EXPECT_DOUBLE_EQ(draw.types[1].rolling_friction, 0.48);
}

TEST(FallDraw, CountsStrataTheSameForAnyWorkersAndOrder) {
    Scene scene{2000};
    std::vector<FallDraw> draws;
    for (int i = 0; i < 16; ++i) {
        draws.push_back(draws_with(scene, {.losses = 0.6 + 0.05 * i}, 1).front());
    }
    scene.assessment.draws = draws;
    std::vector<Chunk> chunks = plan_chunks(scene.sources, 150);
    const EnsembleTally one = tally_of(scene, chunks, 1);
    std::reverse(chunks.begin(), chunks.end());
    const EnsembleTally five = tally_of(scene, chunks, 5);
    std::uint64_t rocks = 0;
    std::uint64_t both = 0;
    ASSERT_EQ(one.strata.size(), 16U);
    for (std::size_t k = 0; k < one.strata.size(); ++k) {
        for (std::size_t c = 0; c < covers; ++c) {
            EXPECT_EQ(one.strata[k].run_outs[c].sum_mm, five.strata[k].run_outs[c].sum_mm);
            EXPECT_EQ(one.strata[k].targets[0].by_cover[c].energy,
                      five.strata[k].targets[0].by_cover[c].energy);
        }
        rocks += one.strata[k].run_outs[0].rocks;
        both += one.strata[k].targets[0].reached_both;
    }
    EXPECT_EQ(rocks, one.runs[0].rocks);
    EXPECT_EQ(both, one.targets[0].reached_both);
    // Where ground takes more, fewer arrive.
    EXPECT_GT(one.strata.front().targets[0].by_cover[1].reached,
              one.strata.back().targets[0].by_cover[1].reached);
}

}  // namespace
}  // namespace rockfall::fall_draw_test
