#include "rockfall/terrain/flatten.hpp"

#include <gtest/gtest.h>

namespace rockfall::flatten_test {
namespace {

/// A row of four unit squares, each cut in two, listed from the wrong end and with a vertex that nobody uses.
Terrain strip() {
    const std::vector<Vertex> vertices = {{4, 1, 9}, {4, 0, 9}, {3, 1, 0}, {3, 0, 0}, {7, 7, 7}, {2, 1, 0},
                                          {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 5}, {0, 0, 5}};
    const std::vector<Triangle> triangles = {
        {{3, 1, 0}, {no_triangle, no_triangle, 1}}, {{3, 0, 2}, {0, no_triangle, 2}},
        {{6, 3, 2}, {no_triangle, 1, 3}},           {{6, 2, 5}, {2, no_triangle, 4}},
        {{8, 6, 5}, {no_triangle, 3, 5}},           {{8, 5, 7}, {4, no_triangle, 6}},
        {{10, 8, 7}, {no_triangle, 5, 7}},          {{10, 7, 9}, {6, no_triangle, no_triangle}},
    };
    return along_hilbert_curve({1000.0, 2000.0}, vertices, triangles);
}

TEST(AlongHilbertCurve, OrdersAStripFromEndToEnd) {
    const Terrain terrain = strip();
    ASSERT_EQ(terrain.triangles().size(), 8U);
    for (std::uint32_t i = 0; i < 8; ++i) {
        double x_m = 0.0;
        for (const std::uint32_t corner : terrain.triangles()[i].corners) {
            x_m += terrain.vertices()[corner].x_m / 3.0;
        }
        EXPECT_NEAR(x_m, i / 2 + 0.5, 0.2) << "triangle " << i;
    }
}

TEST(AlongHilbertCurve, LeavesOutVerticesThatNoTriangleUses) {
    const Terrain terrain = strip();
    EXPECT_EQ(terrain.vertices().size(), 10U);
    for (const Vertex& vertex : terrain.vertices()) {
        EXPECT_LT(vertex.y_m, 2.0);
    }
}

TEST(AlongHilbertCurve, KeepsPlacesHeightsAndOrigin) {
    const Terrain terrain = strip();
    EXPECT_EQ(terrain.origin_m(), (Eigen::Vector2d{1000.0, 2000.0}));
    EXPECT_DOUBLE_EQ(terrain.height_m(0.5, 0.5).value(), 2.5);
    EXPECT_DOUBLE_EQ(terrain.height_m(2.0, 0.5).value(), 0.0);
    EXPECT_DOUBLE_EQ(terrain.height_m(3.75, 0.25).value(), 6.75);
}

}  // namespace
}  // namespace rockfall::flatten_test
