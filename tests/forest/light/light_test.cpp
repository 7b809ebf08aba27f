#include "forest/light/light.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/forest/light/stands.hpp"

namespace light_test {
namespace {

using forest::Canopy;
using forest::Edges;
using forest::LightField;
using forest::LightGround;
using forest::LightSite;
using forest::LightTree;

/// A stand that RapidCheck chooses: places, sizes and number of the trees, and how the ground lies.
struct RandomStand {
    LightGround ground;
    std::vector<LightTree> trees;
};

RandomStand random_stand(Edges edges, std::size_t least_trees = 0) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint64_t>(), 0, 0, 0}, config::Purpose::test};
    const double rise_x = 1.2 * (stream.uniform() - 0.5);
    const double rise_y = 1.2 * (stream.uniform() - 0.5);
    RandomStand stand{stands::plane(5, 4, rise_x, rise_y, edges), {}};
    const std::size_t count = *rc::gen::inRange<std::size_t>(least_trees, 60);
    stand.trees = stands::random_trees(stream, count, 50.0, 40.0, true);
    return stand;
}

double total(const std::vector<float>& by_month, std::size_t month) {
    double sum = 0.0;
    for (std::size_t i = month; i < by_month.size(); i += 12) {
        sum += static_cast<double>(by_month[i]);
    }
    return sum;
}

RC_GTEST_PROP(Light, StaysBetweenDarkAndOpen, ()) {
    const Edges edges = *rc::gen::element(Edges::open, Edges::mirror, Edges::torus);
    const RandomStand stand = random_stand(edges);
    const LightField field = stands::light(stands::site(stand.ground), stand.trees);
    for (const float ratio : field.light_ratio) {
        RC_ASSERT((ratio >= 0.0F && ratio <= 1.0F));
    }
    for (const float light : field.ground_light) {
        RC_ASSERT((light >= 0.0F && light <= 1.0F));
    }
    for (const float energy : field.absorbed_mj) {
        RC_ASSERT(energy >= 0.0F);
    }
}

RC_GTEST_PROP(Light, NeverDarkensWhenANeighbourGoes, ()) {
    RandomStand stand = random_stand(*rc::gen::element(Edges::open, Edges::torus), 2);
    for (LightTree& tree : stand.trees) {
        tree.deciduous = false;  // a last deciduous tree could switch the winter canopy off
    }
    const LightSite site = stands::site(stand.ground);
    const LightField before = stands::light(site, stand.trees);
    const auto gone = *rc::gen::inRange<std::size_t>(0, stand.trees.size());
    std::vector<LightTree> rest = stand.trees;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(gone));
    const LightField after = stands::light(site, rest);
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const std::size_t was = i < gone ? i : i + 1;
        RC_ASSERT(after.light_ratio[i] >= before.light_ratio[was] - 2e-5F);
    }
    for (std::size_t column = 0; column < before.ground_light.size(); ++column) {
        RC_ASSERT(after.ground_light[column] >= before.ground_light[column] - 2e-5F);
    }
}

RC_GTEST_PROP(Light, ClosesTheBudgetOfATorus, ()) {
    const RandomStand stand = random_stand(Edges::torus, 20);
    const LightField field = stands::light(stands::site(stand.ground), stand.trees);
    for (std::size_t month = 0; month < 12; ++month) {
        const double incoming_mj = 100.0 * total(field.incoming_mjpm2, month);
        const double out_mj = 100.0 * total(field.ground_mjpm2, month) + total(field.absorbed_mj, month);
        RC_ASSERT(std::abs(out_mj / incoming_mj - 1.0) < 1e-5);
        // Before scaling: what is missing or too much, as a share of what came in.
        const double scaled_mj = total(field.absorbed_mj, month) * (1.0 - 1.0 / field.closure[month]);
        RC_ASSERT(std::abs(scaled_mj / incoming_mj) < 0.06);
    }
}

TEST(Light, ClosesTheBudgetOfEvenLeavesUnscaled) {
    for (const double rise_y : {0.0, -0.7}) {
        const LightGround ground = stands::plane(4, 4, 0.0, rise_y);
        for (const double leaf_area_index : {0.5, 2.0, 5.0}) {
            const auto trees = stands::even_leaves(ground.elevation_m.frame, leaf_area_index, 5, 0.5);
            const LightField field = stands::light(stands::site(ground), trees);
            for (const double closure : field.closure) {
                EXPECT_NEAR(closure, 1.0, 0.001) << rise_y << " " << leaf_area_index;
            }
        }
    }
}

TEST(Light, BringsToTheGroundWhatTheSlopeGets) {
    const LightGround ground = stands::plane(3, 3, 0.3, 0.6);
    const LightField field = stands::light(stands::site(ground), {});
    const forest::SlopeRadiation slope =
        slope_radiation(stands::sky(), forest::exposures_of(ground, {})[0], stands::year().radiation);
    for (std::size_t month = 0; month < 12; ++month) {
        const double on_slope = slope.slope.direct_mjpm2[month] + slope.slope.diffuse_mjpm2[month];
        const double cosine = forest::exposures_of(ground, {})[0].normal.z;
        EXPECT_NEAR(field.incoming_mjpm2[month] * cosine / on_slope, 1.0, 0.01) << month;
    }
}

RC_GTEST_PROP(Light, IsTheSameInTheMirror, ()) {
    const RandomStand stand = random_stand(Edges::torus, 1);
    RandomStand mirrored = stand;
    const config::GridFrame& frame = stand.ground.elevation_m.frame;
    for (std::size_t cell = 0; cell < frame.size(); ++cell) {
        const config::Cell at = frame.cell_of(cell);
        mirrored.ground.elevation_m.values[cell] =
            stand.ground.elevation_m.at({frame.columns - 1 - at.column, at.row});
    }
    mirrored.ground.gain_x_m = -stand.ground.gain_x_m;
    for (LightTree& tree : mirrored.trees) {
        tree.x_m = frame.x_east_m() - tree.x_m;
    }
    const LightField one = stands::light(stands::site(stand.ground), stand.trees);
    const LightField other = stands::light(stands::site(mirrored.ground), mirrored.trees);
    for (std::size_t i = 0; i < stand.trees.size(); ++i) {
        RC_ASSERT(std::abs(one.light_ratio[i] - other.light_ratio[i]) < 2e-3F);
    }
    for (std::size_t cell = 0; cell < frame.size(); ++cell) {
        const config::Cell at = frame.cell_of(cell);
        const std::size_t there = frame.index({frame.columns - 1 - at.column, at.row});
        RC_ASSERT(std::abs(one.ground_light[cell] - other.ground_light[there]) < 2e-3F);
    }
}

RC_GTEST_PROP(Light, HasTheSameBytesForAnyOrderOfTrees, ()) {
    const RandomStand stand = random_stand(Edges::torus);
    std::vector<std::size_t> order(stand.trees.size());
    std::iota(order.begin(), order.end(), 0);
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint64_t>(), 0, 0, 0}, config::Purpose::test};
    for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[static_cast<std::size_t>(stream.uniform() * static_cast<double>(i))]);
    }
    std::vector<LightTree> shuffled;
    for (const std::size_t i : order) {
        shuffled.push_back(stand.trees[i]);
    }
    const LightSite site = stands::site(stand.ground);
    const LightField one = stands::light(site, stand.trees);
    const LightField other = stands::light(site, shuffled);
    RC_ASSERT(one.cells == other.cells);
    RC_ASSERT(one.ground_mjpm2 == other.ground_mjpm2);
    RC_ASSERT(one.closure == other.closure);
    for (std::size_t i = 0; i < order.size(); ++i) {
        RC_ASSERT(one.light_ratio[order[i]] == other.light_ratio[i]);
        RC_ASSERT(one.absorbed_mj[order[i] * 12 + 6] == other.absorbed_mj[i * 12 + 6]);
    }
}

TEST(Light, HasTheSameBytesInPieces) {
    config::RandomStream stream{{5, 0, 0, 0}, config::Purpose::test};
    const LightGround ground = stands::plane(5, 4, 0.1, 0.4, Edges::mirror);
    const auto trees = stands::random_trees(stream, 50, 50.0, 40.0, true);
    const LightSite site = stands::site(ground);
    const LightField whole = stands::light(site, trees);
    const Canopy canopy{site.ground(), trees};
    // A field that was used before.
    LightField pieces = stands::light(site, stands::random_trees(stream, 50, 50.0, 40.0, true));
    for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{13, 20}, {0, 7}, {7, 13}}) {
        forest::compute_columns(site, canopy, stands::year(), first, last, pieces);
    }
    forest::compute_trees(canopy, stands::year(), trees, 30, 50, pieces);
    forest::compute_trees(canopy, stands::year(), trees, 0, 30, pieces);
    forest::close_budget(site, pieces);
    EXPECT_EQ(whole.cells, pieces.cells);
    EXPECT_EQ(whole.light_ratio, pieces.light_ratio);
    EXPECT_EQ(whole.absorbed_mj, pieces.absorbed_mj);
    EXPECT_EQ(whole.june_sun_hours, pieces.june_sun_hours);
}

TEST(MeanOverPatches, TakesTheColumnsOfEachPatch) {
    const config::GridFrame frame{4, 2, 0.0, 0.0, 5.0, 5.0};
    const std::vector<float> values{1, 2, 5, 5, 3, 4, 5, 5};
    EXPECT_EQ(forest::mean_over_patches(frame, values, 2), (std::vector<float>{2.5F, 5.0F}));
    EXPECT_EQ(forest::mean_over_patches(frame, values, 1), values);
}

TEST(Light, IsOpenWithoutTrees) {
    const LightField field = stands::light(stands::site(stands::plane(1, 1, 0.0, 0.0)), {});
    EXPECT_FLOAT_EQ(field.ground_light[0], 1.0F);
    EXPECT_EQ(field.closure[6], 1.0);
    EXPECT_GT(field.june_sun_hours[0], 13.0F);  // of 15.7 h at 47 N those above 5 degrees, in half hours
    EXPECT_LT(field.june_sun_hours[0], 15.5F);
}

TEST(Light, IsThatOfTheOpenForALonelyTree) {
    const std::vector<LightTree> one{{.x_m = 55.0,
                                      .y_m = 55.0,
                                      .crown_base_m = 3.0,
                                      .height_m = 18.0,
                                      .crown_radius_m = 2.0,
                                      .leaf_area_m2 = 40.0}};
    const LightField field = stands::light(stands::site(stands::plane(11, 11, 0.0, 0.0, Edges::open)), one);
    EXPECT_GT(field.light_ratio[0], 0.95F);
    EXPECT_GT(field.absorbed_mj[6], field.absorbed_mj[0]);
    const std::vector<LightTree> bare{{.x_m = 5.0, .y_m = 5.0, .height_m = 2.0}};
    EXPECT_GT(stands::light(stands::site(stands::plane(1, 1, 0.0, 0.0)), bare).light_ratio[0], 0.999F);
}

TEST(Light, ShadesTheSmallUnderTheTall) {
    const LightGround ground = stands::plane(6, 6, 0.0, 0.0);
    std::vector<LightTree> trees = stands::even_leaves(ground.elevation_m.frame, 4.0, 4, 0.55);
    trees.push_back({.x_m = 25.0, .y_m = 25.0, .height_m = 4.0, .crown_radius_m = 1.0, .leaf_area_m2 = 5.0});
    const LightField field = stands::light(stands::site(ground), trees);
    EXPECT_LT(field.light_ratio.back(), 0.2F);
    EXPECT_LT(field.ground_light[0], 0.12F);
    EXPECT_EQ(field.june_sun_hours[0], 0.0F);
}

TEST(Light, ComesThroughBareCrownsInWinter) {
    const LightGround ground = stands::plane(4, 4, 0.0, 0.0);
    std::vector<LightTree> trees = stands::even_leaves(ground.elevation_m.frame, 3.0, 4, 0.55);
    for (LightTree& tree : trees) {
        tree.deciduous = true;
    }
    const LightField field = stands::light(stands::site(ground), trees);
    EXPECT_EQ(field.absorbed_mj[0], 0.0F);
    EXPECT_NEAR(field.ground_mjpm2[0] / field.incoming_mjpm2[0], 1.0, 1e-5);
    EXPECT_GT(field.absorbed_mj[6], 0.0F);
    EXPECT_LT(field.ground_mjpm2[6] / field.incoming_mjpm2[6], 0.3F);
}

TEST(Light, GoesOnBehindMirroredEdges) {
    const LightGround inside = stands::plane(3, 3, 0.0, 0.3, Edges::mirror);
    const auto trees = stands::even_leaves(inside.elevation_m.frame, 2.0, 4, 0.5);
    const LightField field = stands::light(stands::site(inside), trees);
    for (const float light : field.ground_light) {
        EXPECT_NEAR(light, field.ground_light[4], 2e-3F);
    }
}

TEST(Light, ComesInAtOpenEdges) {
    const LightGround stand = stands::plane(9, 9, 0.0, 0.0, Edges::open);
    const auto trees = stands::even_leaves(stand.elevation_m.frame, 3.0, 5, 0.5);
    const LightField field = stands::light(stands::site(stand), trees);
    const config::GridFrame& frame = stand.elevation_m.frame;
    const float south_edge = field.ground_light[frame.index({4, 8})];
    EXPECT_GT(south_edge, field.ground_light[frame.index({4, 0})]);
    EXPECT_GT(south_edge, 1.2F * field.ground_light[frame.index({4, 4})]);
    // Closure is told but not used: light that comes in from the side belongs to the trees.
    EXPECT_NE(field.closure[6], 1.0);
}

}  // namespace

}  // namespace light_test
