#include "rockfall/terrain/breaklines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rockfall/terrain/mesh.hpp"

namespace rockfall::breaklines_test {
namespace {

/// Whether two places in terrain coordinates are joined by an edge.
bool has_edge(const Terrain& terrain, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const auto is_at = [&](std::uint32_t vertex, const Eigen::Vector2d& place) {
        const Vertex& v = terrain.vertices()[vertex];
        return std::hypot(v.x_m - place.x(), v.y_m - place.y()) < 1e-9;
    };
    return std::any_of(terrain.triangles().begin(), terrain.triangles().end(), [&](const Triangle& t) {
        const auto corner_at = [&](const Eigen::Vector2d& place) {
            return std::any_of(std::begin(t.corners), std::end(t.corners),
                               [&](std::uint32_t corner) { return is_at(corner, place); });
        };
        return corner_at(a) && corner_at(b);
    });
}

/// A flat kite: without constraint the short diagonal (0, 1) to (0, -1) is an edge.
const std::vector<Eigen::Vector3d> kite{
    {-10.0, 0.0, 5.0}, {10.0, 0.0, 5.0}, {0.0, 1.0, 3.0}, {0.0, -1.0, 3.0}};

TEST(Breaklines, AreEdges) {
    const Terrain free = triangulate(kite, 0.0);
    const Terrain tied = triangulate(kite, std::vector<PointPair>{{0, 1}}, 0.0);
    const Eigen::Vector2d west = Eigen::Vector2d{-10.0, 0.0} - tied.origin_m();
    const Eigen::Vector2d east = Eigen::Vector2d{10.0, 0.0} - tied.origin_m();
    EXPECT_FALSE(has_edge(free, west, east));
    EXPECT_TRUE(has_edge(tied, west, east));
    EXPECT_EQ(tied.triangles().size(), 2U);
    // Along a ridge between the two high points the ground is high.
    EXPECT_DOUBLE_EQ(*tied.height_m(-tied.origin_m().x(), -tied.origin_m().y()), 5.0);
    EXPECT_DOUBLE_EQ(*free.height_m(-free.origin_m().x(), -free.origin_m().y()), 3.0);
}

TEST(Breaklines, GoThroughPointsThatLieOnThem) {
    std::vector<Eigen::Vector3d> points = kite;
    points.emplace_back(0.0, 0.0, 4.0);
    const Terrain terrain = triangulate(points, std::vector<PointPair>{{0, 1}}, 0.0);
    EXPECT_DOUBLE_EQ(*terrain.height_m(-terrain.origin_m().x(), -terrain.origin_m().y()), 4.0);
    EXPECT_EQ(terrain.triangles().size(), 4U);
}

TEST(Breaklines, MeetAtPointsGivenTwice) {
    // Two lines end at one place, each with a point of its own there.
    std::vector<Eigen::Vector3d> points = kite;
    points.push_back(kite[1]);
    EXPECT_EQ(crossing_of(points, std::vector<PointPair>{{0, 1}, {4, 2}}), std::nullopt);
    const Terrain terrain = triangulate(points, std::vector<PointPair>{{0, 1}, {4, 2}}, 0.0);
    EXPECT_EQ(terrain.vertices().size(), 4U);
    EXPECT_EQ(terrain.triangles().size(), 2U);
}

TEST(Breaklines, ThatCrossAreToldWithThePlace) {
    const auto place_m = crossing_of(kite, std::vector<PointPair>{{0, 1}, {2, 3}});
    ASSERT_TRUE(place_m);
    EXPECT_NEAR(place_m->norm(), 0.0, 1e-12);
}

TEST(Breaklines, OfNoneAreScatteredPoints) {
    const Terrain free = triangulate(kite, 0.0);
    const Terrain none = triangulate(kite, std::vector<PointPair>{}, 0.0);
    EXPECT_EQ(free.triangles().size(), none.triangles().size());
    EXPECT_TRUE(
        triangulate(std::vector<Eigen::Vector3d>{}, std::vector<PointPair>{}, 0.0).triangles().empty());
}

}  // namespace
}  // namespace rockfall::breaklines_test
