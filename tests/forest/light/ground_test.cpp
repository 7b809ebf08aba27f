#include "forest/light/ground.hpp"

#include <gtest/gtest.h>

#include "tests/forest/light/stands.hpp"

namespace ground_test {
namespace {

using forest::Edges;
using forest::PaddedGround;

constexpr int margin = 8;

/// Place of a column outside or inside, counted from the north-western column of the area.
std::size_t place(const PaddedGround& ground, int column, int row) {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(ground.padded(0)) +
                                    row * static_cast<std::ptrdiff_t>(ground.stride()) + column);
}

TEST(PaddedGround, HasTheSlopeOfAPlaneUpToItsBorders) {
    for (const Edges edges : {Edges::open, Edges::mirror, Edges::torus}) {
        const PaddedGround ground{stands::plane(4, 3, 0.3, -0.5, edges), margin};
        for (std::size_t column = 0; column < 12; ++column) {
            EXPECT_NEAR(ground.gradient(column).x, 0.3, 1e-5) << static_cast<int>(edges);
            EXPECT_NEAR(ground.gradient(column).y, -0.5, 1e-5) << static_cast<int>(edges);
        }
    }
}

TEST(PaddedGround, GoesOnRisingOnATorusAndUnderMirroredTrees) {
    for (const Edges edges : {Edges::mirror, Edges::torus}) {
        const PaddedGround ground{stands::plane(4, 3, 0.3, -0.5, edges), margin};
        const auto height_m = [&](int column, int row) {
            return ground.elevation_m()[place(ground, column, row)];
        };
        EXPECT_NEAR(height_m(9, 1) - height_m(0, 1), 27.0, 1e-3);
        EXPECT_NEAR(height_m(-5, -4) - height_m(0, 0), -15.0 - 20.0, 1e-3);
        EXPECT_NEAR(height_m(2, 7) - height_m(2, 0), 35.0, 1e-3);
    }
}

TEST(PaddedGround, IsLevelBehindOpenEdges) {
    const PaddedGround ground{stands::plane(4, 3, 0.3, 0.0, Edges::open), margin};
    const auto height_m = [&](int column, int row) {
        return ground.elevation_m()[place(ground, column, row)];
    };
    EXPECT_NEAR(height_m(4, 1) - height_m(3, 1), 3.0, 1e-5);
    EXPECT_EQ(height_m(9, 1), height_m(4, 1));
    EXPECT_EQ(ground.source(place(ground, 4, 1)), PaddedGround::none);
    EXPECT_EQ(ground.source(place(ground, 3, 1)), 7U);
}

TEST(PaddedGround, KnowsWhoseTreesStandOutside) {
    const PaddedGround torus{stands::plane(4, 3, 0.0, 0.0, Edges::torus), margin};
    EXPECT_EQ(torus.source(place(torus, -1, 0)), 3U);
    EXPECT_EQ(torus.source(place(torus, 9, 4)), 5U);
    const PaddedGround mirror{stands::plane(4, 3, 0.0, 0.0, Edges::mirror), margin};
    EXPECT_EQ(mirror.source(place(mirror, -1, 0)), 0U);
    EXPECT_EQ(mirror.source(place(mirror, 4, 3)), 11U);
    EXPECT_EQ(mirror.source(place(mirror, -5, 0)), 3U);
}

TEST(PaddedGround, TakesASingleColumn) {
    const PaddedGround ground{stands::plane(1, 1, 0.0, 0.4), 3};
    EXPECT_NEAR(ground.gradient(0).y, 0.4, 1e-5);
    EXPECT_NEAR(ground.normal(0).z, 1.0 / std::sqrt(1.16), 1e-5);
}

}  // namespace

}  // namespace ground_test
