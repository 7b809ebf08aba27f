#include "coupling/assessments/nets/figures/net_uphill.hpp"

#include <gtest/gtest.h>

namespace coupling::net_uphill_test {
namespace {

/// A square of 100 m that falls towards the east.
rockfall::Terrain slope_to_the_east() {
    constexpr std::uint32_t none = rockfall::no_triangle;
    return {{0.0, 0.0},
            {{0.0, 0.0, 50.0}, {100.0, 0.0, 0.0}, {100.0, 100.0, 0.0}, {0.0, 100.0, 50.0}},
            {{{0, 1, 2}, {none, none, 1}}, {{0, 2, 3}, {0, none, none}}}};
}

std::vector<NetRecord> line_to_the_north() {
    NetRecord line;
    line.net = {{{50.0, 10.0}, {50.0, 90.0}}, 3.0, 0.0, 1e5};
    return {line};
}

StoredPath flight(rockfall::Cover cover, const Eigen::Vector3d& start_m,
                  const Eigen::Vector3d& velocity_mps) {
    StoredPath path;
    path.cover = cover;
    path.body = {1.0, 0.5, 1000.0, 100.0};
    path.pieces.push_back({0, true, false, start_m, velocity_mps, 10.0, 0.0});
    return path;
}

TEST(Uphill, IsThatOfTheGroundWhereNoRockComes) {
    const rockfall::Terrain terrain = slope_to_the_east();
    const std::vector<NetRecord> lines = line_to_the_north();
    const auto uphill = Arrivals{lines, terrain}.uphill(0);
    ASSERT_TRUE(uphill);
    EXPECT_EQ(uphill->from, Uphill::From::gradient);
    EXPECT_NEAR(uphill->azimuth_deg(), 270.0, 1e-9);
}

TEST(Uphill, IsWhereRocksComeFromWhateverTheGroundSays) {
    const rockfall::Terrain terrain = slope_to_the_east();
    const std::vector<NetRecord> lines = line_to_the_north();
    Arrivals arrivals{lines, terrain};
    arrivals.look(flight(rockfall::Cover::bare, {55.0, 50.0, 40.0}, {-1.0, 1.0, 0.0}));
    arrivals.look(flight(rockfall::Cover::bare, {55.0, 50.0, 40.0}, {-3.0, -3.0, 0.0}));
    auto uphill = arrivals.uphill(0);
    ASSERT_TRUE(uphill);
    EXPECT_EQ(uphill->from, Uphill::From::rocks);
    EXPECT_EQ(uphill->rocks, 2U);
    EXPECT_NEAR(uphill->azimuth_deg(), 90.0, 1e-9);
    // Rocks through the forest count before those of the bare slope.
    arrivals.look(flight(rockfall::Cover::forest, {45.0, 50.0, 40.0}, {1.0, 0.0, 0.0}));
    EXPECT_NEAR(arrivals.uphill(0)->azimuth_deg(), 270.0, 1e-9);
    // From both sides alike: the ground decides.
    arrivals.look(flight(rockfall::Cover::forest, {55.0, 50.0, 40.0}, {-1.0, 0.0, 0.0}));
    EXPECT_EQ(arrivals.uphill(0)->from, Uphill::From::gradient);
}

TEST(Uphill, GoesAlongAGivenAzimuth) {
    EXPECT_NEAR(uphill_along(90.0).direction.x(), 1.0, 1e-12);
    EXPECT_NEAR(uphill_along(0.0).direction.y(), 1.0, 1e-12);
    EXPECT_NEAR(uphill_along(225.0).azimuth_deg(), 225.0, 1e-9);
}

}  // namespace
}  // namespace coupling::net_uphill_test
