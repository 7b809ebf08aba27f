#include "forest/light/canopy.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/forest/light/stands.hpp"

namespace canopy_test {
namespace {

using forest::Canopy;
using forest::CrownShape;
using forest::LightTree;
using forest::PaddedGround;
using forest::PrefixSums;

const PaddedGround flat{stands::plane(4, 4, 0.0, 0.0), 3};

/// Extinction-weighted leaf area of a column.
double leaves_of(const PaddedGround& ground, const PrefixSums& sums, std::size_t column) {
    return static_cast<double>(sums.of(ground.padded(column))[PrefixSums::nodes - 1]) * 100.0;
}

double all_leaves(const PaddedGround& ground, const PrefixSums& sums) {
    double sum = 0.0;
    for (std::size_t column = 0; column < ground.frame().size(); ++column) {
        sum += leaves_of(ground, sums, column);
    }
    return sum;
}

LightTree fir() {
    return {.x_m = 15.0,
            .y_m = 15.0,
            .crown_base_m = 0.0,
            .height_m = 20.0,
            .crown_radius_m = 2.0,
            .leaf_area_m2 = 80.0,
            .extinction = 0.5,
            .shape = CrownShape::paraboloid,
            .deciduous = false};
}

TEST(Canopy, HasTheLeavesOfACrownInItsLayers) {
    const std::vector<LightTree> trees{fir()};
    const Canopy canopy{flat, trees};
    const std::size_t column = flat.frame().index(flat.frame().cell_at(15.0, 15.0));
    const float* nodes = canopy.leaf_on().of(flat.padded(column)) + PrefixSums::nodes_below;
    for (int layer = 1; layer <= 4; ++layer) {
        // Volume of a paraboloid above relative height u: (1 - u)^2. Four rings come within a fiftieth.
        const double above = (1.0 - layer / 4.0) * (1.0 - layer / 4.0);
        EXPECT_NEAR(nodes[layer], 0.5 * 80.0 / 100.0 * (1.0 - above), 0.02 * 0.4) << layer;
    }
    EXPECT_EQ(canopy.layers_used(column), 4U);
    EXPECT_EQ(canopy.top_m(), 20.0);
}

TEST(Canopy, FillsAnEllipsoidMostInTheMiddle) {
    LightTree beech = fir();
    beech.shape = CrownShape::ellipsoid;
    const std::vector<LightTree> trees{beech};
    const Canopy canopy{flat, trees};
    const std::size_t column = flat.frame().index(flat.frame().cell_at(15.0, 15.0));
    const float* nodes = canopy.leaf_on().of(flat.padded(column)) + PrefixSums::nodes_below;
    for (int layer = 1; layer <= 4; ++layer) {
        const double u = layer / 4.0;
        EXPECT_NEAR(nodes[layer], 0.4 * u * u * (3.0 - 2.0 * u), 0.02 * 0.4) << layer;
    }
}

TEST(Canopy, SharesACrownBetweenColumns) {
    LightTree between = fir();
    between.x_m = 20.0;
    between.y_m = 20.0;
    const std::vector<LightTree> trees{between};
    const Canopy canopy{flat, trees};
    for (const double x_m : {15.0, 25.0}) {
        for (const double y_m : {15.0, 25.0}) {
            const std::size_t column = flat.frame().index(flat.frame().cell_at(x_m, y_m));
            // Some points lie right on the border and count on one side of it.
            EXPECT_NEAR(leaves_of(flat, canopy.leaf_on(), column), 10.0, 4.0) << x_m << " " << y_m;
        }
    }
}

TEST(Canopy, LiftsTheLowerSideOfACrownOnASlope) {
    const PaddedGround slope{stands::plane(4, 4, 0.0, 1.0), 3};
    LightTree wide = fir();
    wide.x_m = 15.0;
    wide.y_m = 20.0;
    wide.crown_base_m = 10.0;
    wide.crown_radius_m = 4.0;
    const std::vector<LightTree> trees{wide};
    const Canopy canopy{slope, trees};
    const auto lowest_layer = [&](double y_m) {
        const std::size_t column = slope.frame().index(slope.frame().cell_at(15.0, y_m));
        return canopy.leaf_on().of(slope.padded(column))[PrefixSums::nodes_below + 2];
    };
    EXPECT_GT(lowest_layer(25.0), 0.0F);  // uphill branches hang below 10 m above the ground
    EXPECT_EQ(lowest_layer(15.0), 0.0F);
}

TEST(Canopy, DropsTheLeavesOfDeciduousTrees) {
    std::vector<LightTree> trees{fir(), fir()};
    trees[1].deciduous = true;
    const Canopy canopy{flat, trees};
    EXPECT_NEAR(canopy.deciduous_share(), 0.5, 1e-6);
    EXPECT_NEAR(all_leaves(flat, canopy.leaf_on()), 80.0, 1e-3);
    EXPECT_NEAR(all_leaves(flat, canopy.leaf_off()), 40.0, 1e-3);
}

TEST(Canopy, TakesTreesOutsideAndAboveTheCanopy) {
    std::vector<LightTree> trees{fir()};
    trees[0].x_m = -500.0;
    trees[0].height_m = 75.0;
    const Canopy canopy{flat, trees};
    EXPECT_NEAR(all_leaves(flat, canopy.leaf_on()), 40.0, 1e-3);
    EXPECT_EQ(canopy.top_m(), forest::canopy_height_m);
}

RC_GTEST_PROP(Canopy, KeepsAllLeavesAndAllShares, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint64_t>(), 0, 0, 0}, config::Purpose::test};
    const PaddedGround ground{stands::plane(5, 3, 0.4, -0.3), 4};
    const auto trees = stands::random_trees(stream, *rc::gen::inRange<std::size_t>(0, 60), 50.0, 30.0, true);
    const Canopy canopy{ground, trees};
    double wanted = 0.0;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        wanted += trees[i].extinction * trees[i].leaf_area_m2;
        double share = 0.0;
        for (const forest::LeafShare& leaves : canopy.cells_of(i)) {
            share += static_cast<double>(leaves.share);
        }
        RC_ASSERT(std::abs(share - 1.0) < 1e-5);
    }
    RC_ASSERT(std::abs(all_leaves(ground, canopy.leaf_on()) - wanted) <= 1e-4 * wanted + 1e-3);
}

}  // namespace

}  // namespace canopy_test
