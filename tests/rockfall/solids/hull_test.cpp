#include "rockfall/solids/hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "rockfall/solids/mass_properties.hpp"
#include "rockfall/solids/shapes.hpp"

namespace rockfall::solids::hull_test {
namespace {

using Eigen::Vector3d;
using Faces = std::vector<std::vector<std::uint32_t>>;

const std::vector<Vector3d> unit_tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

std::string refusal_of(const std::vector<Vector3d>& points_m) {
    try {
        convex_hull(points_m);
    } catch (const NoSolid& error) {
        return error.what();
    }
    return "";
}

std::string refusal_of(const std::vector<Vector3d>& points_m, const Faces& faces) {
    try {
        hull_of_faces(points_m, faces);
    } catch (const NoSolid& error) {
        return error.what();
    }
    return "";
}

std::vector<Vector3d> random_points(std::size_t count, std::uint64_t seed) {
    std::vector<Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint64_t state = seed * 1000003 + i;
        Vector3d point;
        for (int k = 0; k < 3; ++k) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            state ^= state >> 29;
            point[k] = static_cast<double>(state >> 11) * 0x1p-53;
        }
        points.push_back(point);
    }
    return points;
}

TEST(Hull, OfABoxHasSixFacesOfFourCorners) {
    const Hull cube = box({1.0, 2.0, 3.0});
    EXPECT_EQ(cube.vertices_m.size(), 8U);
    EXPECT_EQ(cube.edges.size(), 12U);
    ASSERT_EQ(cube.faces.size(), 6U);
    for (const Face& face : cube.faces) {
        EXPECT_EQ(face.corners.size(), 4U);
        EXPECT_EQ(face.normal.cwiseAbs().sum(), 1.0);
    }
}

TEST(Hull, LeavesOutPointsInsideOnFacesAndOnEdges) {
    std::vector<Vector3d> grid;
    for (int x = 0; x <= 4; ++x) {
        for (int y = 0; y <= 4; ++y) {
            for (int z = 0; z <= 4; ++z) {
                grid.emplace_back(x, y, z);
            }
        }
    }
    const Hull cube = convex_hull(grid);
    EXPECT_EQ(cube.vertices_m.size(), 8U);
    EXPECT_EQ(cube.faces.size(), 6U);
}

TEST(Hull, HoldsAllPointsAndObeysEuler) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const std::vector<Vector3d> points = random_points(5 + 10 * seed, seed);
        const Hull hull = convex_hull(points);
        EXPECT_EQ(hull.vertices_m.size() + hull.faces.size(), hull.edges.size() + 2);
        for (const Face& face : hull.faces) {
            for (const Vector3d& point : points) {
                EXPECT_LE(face.normal.dot(point) - face.offset_m, 1e-8);
            }
        }
    }
}

TEST(Hull, DoesNotDependOnTheOrderOfPoints) {
    std::vector<Vector3d> points = random_points(100, 7);
    const double volume_m3 = volume_integrals(convex_hull(points)).volume_m3;
    std::reverse(points.begin(), points.end());
    EXPECT_NEAR(volume_integrals(convex_hull(points)).volume_m3, volume_m3, 1e-14);
}

TEST(Hull, RefusesPointsThatSpanNoSolid) {
    const double nan = std::nan("");
    EXPECT_EQ(refusal_of({{1, 2, 3}}), "a solid needs at least four points, not 1");
    EXPECT_EQ(refusal_of({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), "all points coincide");
    EXPECT_EQ(refusal_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}), "all points lie on one line");
    EXPECT_EQ(refusal_of({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}), "all points lie in one plane");
    EXPECT_EQ(refusal_of({{0, 0, nan}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}), "a coordinate is no finite number");
}

TEST(Hull, TakesFacesAndRefusesFaultyOnes) {
    const Faces good{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    EXPECT_EQ(hull_of_faces(unit_tetrahedron, good).faces.size(), 4U);
    EXPECT_EQ(refusal_of(unit_tetrahedron, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}),
              "the faces point inwards: their corners run clockwise seen from outside");
    EXPECT_EQ(refusal_of(unit_tetrahedron, {{0, 1, 2}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}),
              "two faces share an edge in the same direction: faces are doubled or inverted");
    EXPECT_EQ(refusal_of(unit_tetrahedron, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}}),
              "4 points and 3 faces make no solid");
    EXPECT_EQ(refusal_of(unit_tetrahedron, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 9}}),
              "a face has fewer than three corners or names a point that does not exist");
    EXPECT_EQ(refusal_of(box({1, 1, 1}).vertices_m, {{0, 2, 1}, {0, 1, 4}, {0, 4, 2}, {1, 2, 7}}),
              "the faces leave a hole");

    // The tip of the tetrahedron pushed in below its opposite face.
    std::vector<Vector3d> dented = unit_tetrahedron;
    dented.emplace_back(0.2, 0.2, 0.2);
    EXPECT_EQ(refusal_of(dented, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}),
              "the solid is not convex");
}

}  // namespace
}  // namespace rockfall::solids::hull_test
