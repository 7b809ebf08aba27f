#include "rockfall/laws/flight.hpp"

#include <gtest/gtest.h>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::flight_test {
namespace {

bool touches(const Terrain& terrain, std::uint32_t triangle, const Eigen::Vector2d& point_m) {
    for (const std::uint32_t corner : terrain.triangles()[triangle].corners) {
        const Vertex& vertex = terrain.vertices()[corner];
        if (vertex.x_m == point_m.x() && vertex.y_m == point_m.y()) {
            return true;
        }
    }
    return false;
}

TEST(Fly, FollowsAnEdgeFromWhicheverTriangleItBeginsIn) {
    // 45 degrees down towards +x: thrown level at 5 m/s a rock comes down after 2 v / g.
    const Slope slope = testing::plane_slope(45.0, {0.3, 0.75});
    const Eigen::Vector2d vertex{25.0, 45.0};  // a cell centre, so a corner of several triangles
    const double ground_m = *slope.terrain.height_m(vertex.x(), vertex.y());
    const Flight flight{{vertex.x(), vertex.y(), ground_m}, {5.0, 0.0, 0.0}};
    const double time_s = 2.0 * 5.0 / config::gravity_mps2;
    std::vector<Stretch> stretches;
    int triangles = 0;
    for (std::uint32_t k = 0; k < slope.terrain.triangles().size(); ++k) {
        if (!touches(slope.terrain, k, vertex)) {
            continue;
        }
        ++triangles;
        const Landing landing = fly(slope.terrain, flight, k, stretches);
        EXPECT_EQ(landing.end, FlightEnd::ground) << "from triangle " << k;
        EXPECT_NEAR(landing.time_s, time_s, 1e-9) << "from triangle " << k;
    }
    EXPECT_GE(triangles, 4);
}

}  // namespace
}  // namespace rockfall::flight_test
