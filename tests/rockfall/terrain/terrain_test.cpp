#include "rockfall/terrain/terrain.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "rockfall/terrain/mesh.hpp"
#include "tests/rockfall/terrain/cgal_oracle.hpp"
#include "tests/rockfall/terrain/sample_slopes.hpp"

namespace rockfall::terrain_test {
namespace {

bool covers(const Terrain& terrain, std::uint32_t triangle, double x_m, double y_m) {
    const Triangle& t = terrain.triangles()[triangle];
    const Vertex point{x_m, y_m, 0.0};
    const auto vertices = terrain.vertices();
    for (std::size_t i = 0; i < 3; ++i) {
        if (twice_area_m2(point, vertices[t.corners[i]], vertices[t.corners[(i + 1) % 3]]) < 0.0) {
            return false;
        }
    }
    return true;
}

bool any_covers(const Terrain& terrain, double x_m, double y_m) {
    for (std::uint32_t i = 0; i < terrain.triangles().size(); ++i) {
        if (covers(terrain, i, x_m, y_m)) {
            return true;
        }
    }
    return false;
}

std::array<std::uint32_t, 3> sorted_corners(const Terrain& terrain, std::uint32_t triangle) {
    const Triangle& t = terrain.triangles()[triangle];
    std::array<std::uint32_t, 3> corners = {t.corners[0], t.corners[1], t.corners[2]};
    std::sort(corners.begin(), corners.end());
    return corners;
}

TEST(Locate, FindsTheTriangleThatCgalFinds) {
    constexpr double extent_m = 300.0;
    const Terrain terrain = triangulate(scattered_points(3000, extent_m, 11), 0.0);
    const CgalOracle oracle{terrain};
    std::mt19937_64 engine{12};
    std::uint32_t hint = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double x_m = extent_m * (1.2 * uniform(engine) - 0.1);
        const double y_m = extent_m * (1.2 * uniform(engine) - 0.1);
        const CgalOracle::Found expected = oracle.locate(x_m, y_m);
        const std::optional<std::uint32_t> walked = terrain.locate(x_m, y_m, hint);
        EXPECT_EQ(walked, terrain.locate(x_m, y_m));
        if (expected.kind == CgalOracle::Found::Kind::triangle) {
            ASSERT_TRUE(walked) << x_m << ", " << y_m;
            EXPECT_EQ(sorted_corners(terrain, *walked), expected.corners);
            hint = *walked;
        } else if (expected.kind == CgalOracle::Found::Kind::outside) {
            EXPECT_FALSE(walked) << x_m << ", " << y_m;
        }
    }
}

TEST(Locate, FollowsARockInShortSteps) {
    constexpr double extent_m = 300.0;
    const Terrain terrain = triangulate(scattered_points(3000, extent_m, 13), 0.0);
    std::mt19937_64 engine{14};
    std::uint32_t hint = terrain.locate(150.0, 150.0).value();
    double x_m = 150.0;
    double y_m = 150.0;
    for (int i = 0; i < 20'000; ++i) {
        x_m = std::clamp(x_m + 8.0 * (uniform(engine) - 0.5), 10.0, extent_m - 10.0);
        y_m = std::clamp(y_m + 8.0 * (uniform(engine) - 0.5), 10.0, extent_m - 10.0);
        const std::optional<std::uint32_t> found = terrain.locate(x_m, y_m, hint);
        ASSERT_TRUE(found);
        ASSERT_TRUE(covers(terrain, *found, x_m, y_m));
        hint = *found;
    }
}

RC_GTEST_PROP(Locate, AgreesWithATestOfEveryTriangle, (std::uint64_t seed)) {
    // Holes in plenty: the border is nowhere convex and the terrain falls apart into islands.
    config::Raster<double> heights = rough_grid(frame_of(14, 11), 0.3, seed);
    punch_holes(heights, *rc::gen::element(0.05, 0.2, 0.4), seed + 1);
    const Terrain terrain = triangulate(heights, *rc::gen::element(0.0, 0.3));
    std::mt19937_64 engine{seed + 2};
    for (int i = 0; i < 100; ++i) {
        const double x_m = 80.0 * uniform(engine) - 5.0;
        const double y_m = 65.0 * uniform(engine) - 5.0;
        const auto hint = static_cast<std::uint32_t>(engine() % (terrain.triangles().size() + 1));
        const std::optional<std::uint32_t> found = terrain.locate(x_m, y_m, hint);
        RC_ASSERT(found.has_value() == any_covers(terrain, x_m, y_m));
        RC_ASSERT((!found || covers(terrain, *found, x_m, y_m)));
        RC_ASSERT(terrain.locate(x_m, y_m).has_value() == found.has_value());
    }
}

TEST(Locate, FindsEveryVertexAndEveryMiddleOfAnEdge) {
    // On a regular grid all these are ties.
    const Terrain terrain = triangulate(rough_grid(frame_of(20, 20, 2.5), 0.3, 15), 0.0);
    const auto vertices = terrain.vertices();
    std::uint32_t hint = 0;
    for (const Triangle& t : terrain.triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vertex& a = vertices[t.corners[i]];
            const Vertex& b = vertices[t.corners[(i + 1) % 3]];
            const std::optional<std::uint32_t> at_corner = terrain.locate(a.x_m, a.y_m, hint);
            ASSERT_TRUE(at_corner);
            EXPECT_TRUE(covers(terrain, *at_corner, a.x_m, a.y_m));
            EXPECT_TRUE(terrain.locate(0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m), *at_corner));
            hint = *at_corner;
        }
    }
}

TEST(Locate, CrossesAHoleToTheGroundBehindIt) {
    config::Raster<double> heights = tilted_grid(frame_of(30, 5, 1.0));
    for (int row = 0; row < 5; ++row) {
        heights.at({15, row}) = missing;  // cuts the terrain in two
    }
    const Terrain terrain = triangulate(heights, 0.0);
    const std::uint32_t west = terrain.locate(5.0, 2.5).value();
    EXPECT_TRUE(terrain.locate(25.0, 2.5, west));
    EXPECT_FALSE(terrain.locate(15.9, 2.5, west));
}

TEST(Locate, RefusesWhatIsNowhere) {
    const Terrain terrain = triangulate(tilted_grid(frame_of(5, 5)), 0.0);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double odd : {missing, infinity, -infinity, 1e300, -1e300}) {
        EXPECT_FALSE(terrain.locate(odd, 10.0));
        EXPECT_FALSE(terrain.locate(10.0, odd, 0));
        EXPECT_FALSE(terrain.locate(odd, odd, no_triangle));
    }
    const Terrain empty{Eigen::Vector2d::Zero(), {}, {}};
    EXPECT_FALSE(empty.locate(0.0, 0.0));
    EXPECT_FALSE(empty.locate(0.0, 0.0, 0));
}

TEST(HeightM, IsThatOfThePlaneEverywhereOnIt) {
    const config::Raster<double> heights = tilted_grid(frame_of(30, 30, 2.5));
    const Terrain terrain = triangulate(heights, 0.0);
    std::mt19937_64 engine{16};
    for (int i = 0; i < 1000; ++i) {
        const double x_m = 2.0 + 71.0 * uniform(engine);  // from the south-western corner of the grid
        const double y_m = 2.0 + 71.0 * uniform(engine);
        const Eigen::Vector2d corner_m =
            Eigen::Vector2d{heights.frame.x_west_m, heights.frame.y_south_m} - terrain.origin_m();
        EXPECT_NEAR(terrain.height_m(corner_m.x() + x_m, corner_m.y() + y_m).value(),
                    1000.0 + 0.25 * x_m + 0.78 * y_m, 1e-9);
    }
}

TEST(Terrain, KnowsTheSlopeOfEachTriangle) {
    const Terrain terrain = triangulate(rough_grid(frame_of(20, 20, 2.5), 0.3, 17), 0.0);
    for (std::uint32_t i = 0; i < terrain.triangles().size(); ++i) {
        EXPECT_FLOAT_EQ(terrain.triangles()[i].normal_z,
                        static_cast<float>(terrain.plane_of(i).normal().z()));
    }
}

TEST(Terrain, PlanesPassThroughTheirThreeCorners) {
    const Terrain terrain = triangulate(scattered_points(300, 100.0, 18), 0.0);
    for (std::uint32_t i = 0; i < terrain.triangles().size(); ++i) {
        for (const std::uint32_t corner : terrain.triangles()[i].corners) {
            const Vertex& vertex = terrain.vertices()[corner];
            EXPECT_NEAR(terrain.plane_of(i).height_m(vertex.x_m, vertex.y_m), vertex.z_m, 1e-6);
        }
    }
}

}  // namespace
}  // namespace rockfall::terrain_test
