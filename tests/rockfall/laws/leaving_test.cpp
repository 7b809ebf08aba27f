#include "rockfall/laws/leaving.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "config/random/stream.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::leaving_test {
namespace {

const Slope& even() {
    static const Slope slope = testing::plane_slope(30.0, {0.3, 0.75});
    return slope;
}

/// A terrace above a wall of 40 m in a strip of 10 m.
const Slope& terrace() {
    static const config::GridFrame frame{20, 10, 0.0, 0.0, 10.0, 10.0};
    static const Slope slope = testing::slope_over(
        testing::heights_of(frame, [](double x, double) { return x < 100.0 ? 500.0 : 460.0; }), {0.3, 0.75});
    return slope;
}

/// Motion on a face from a place in plan, in coordinates of the terrain, with an even acceleration.
RollingPiece piece_from(const Slope& slope, std::uint32_t triangle, const Eigen::Vector2d& place_m,
                        const Eigen::Vector2d& velocity_mps,
                        const Eigen::Vector2d& acceleration_mps2 = Eigen::Vector2d::Zero()) {
    const Plane plane = slope.terrain.plane_of(triangle);
    const auto on_face = [&](const Eigen::Vector2d& v) {
        return Eigen::Vector3d{v.x(), v.y(), plane.gradient.dot(v)};
    };
    return {{place_m.x(), place_m.y(), plane.height_m(place_m.x(), place_m.y())},
            on_face(velocity_mps),
            on_face(acceleration_mps2),
            100.0,
            RollingEnd::standstill,
            triangle};
}

Eigen::Vector2d centre_of(const Terrain& terrain, std::uint32_t triangle) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const auto corner : terrain.triangles()[triangle].corners) {
        sum += Eigen::Vector2d{terrain.vertices()[corner].x_m, terrain.vertices()[corner].y_m};
    }
    return sum / 3.0;
}

std::uint32_t under(const Slope& slope, double x_m, double y_m) {
    const Eigen::Vector2d place_m = Eigen::Vector2d{x_m, y_m} - slope.terrain.origin_m();
    return slope.terrain.locate(place_m.x(), place_m.y()).value();
}

RC_GTEST_PROP(Leaving, IsWhereTheWalkFindsTheNextTriangle, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 0, 0, 0}, config::Purpose::test};
    const Terrain& terrain = even().terrain;
    const std::uint32_t triangle =
        under(even(), 100.0 + 800.0 * stream.uniform(), 20.0 + 60.0 * stream.uniform());
    const auto drawn = [&](double size) {
        const double angle = 2.0 * std::numbers::pi * stream.uniform();
        return Eigen::Vector2d{size * std::cos(angle), size * std::sin(angle)};
    };
    const RollingPiece piece = piece_from(even(), triangle, centre_of(terrain, triangle),
                                          drawn(0.5 + 9.0 * stream.uniform()), drawn(4.0 * stream.uniform()));
    const Leaving out = leaving(terrain, triangle, piece);
    RC_ASSERT(std::isfinite(out.time_s));
    const auto triangle_at = [&](double time_s) {
        const Eigen::Vector3d place_m = piece.position_m(time_s);
        return terrain.locate(place_m.x(), place_m.y(), triangle).value();
    };
    const double moment_s = 1e-6 * out.time_s;
    RC_ASSERT(triangle_at(out.time_s - moment_s) == triangle);
    RC_ASSERT(triangle_at(out.time_s + moment_s) != triangle);
    // It never lay outside before: the first of all edges was found.
    for (int i = 0; i < 50; ++i) {
        RC_ASSERT(triangle_at(out.time_s * i / 50.0) == triangle);
    }
}

RC_GTEST_PROP(Leaving, InTimeIsTheSameForPiecesThatLeaveAndNoneForOthers, ()) {
    config::RandomStream stream{{*rc::gen::arbitrary<std::uint32_t>(), 1, 0, 0}, config::Purpose::test};
    const Terrain& terrain = even().terrain;
    const std::uint32_t triangle =
        under(even(), 100.0 + 800.0 * stream.uniform(), 20.0 + 60.0 * stream.uniform());
    const auto drawn = [&](double size) {
        const double angle = 2.0 * std::numbers::pi * stream.uniform();
        return Eigen::Vector2d{size * std::cos(angle), size * std::sin(angle)};
    };
    RollingPiece piece = piece_from(even(), triangle, centre_of(terrain, triangle),
                                    drawn(9.0 * stream.uniform()), drawn(6.0 * stream.uniform()));
    const Leaving whenever = leaving(terrain, triangle, piece);
    // Ends anywhere, just before the edge, on it or just behind.
    const double around_edge = *rc::gen::element(0.5, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 2.0);
    piece.duration_s = std::isfinite(whenever.time_s) ? around_edge * whenever.time_s : stream.uniform();
    const Leaving in_time = leaving_in_time(terrain, triangle, piece);
    if (whenever.time_s <= piece.duration_s) {
        RC_ASSERT(in_time.time_s == whenever.time_s);
        RC_ASSERT(in_time.edge == whenever.edge);
    } else {
        RC_ASSERT(in_time.time_s > piece.duration_s);
    }
}

TEST(Leaving, NeverComesForARockThatStandsOrTurnsBack) {
    const std::uint32_t triangle = under(even(), 500.0, 52.0);
    const Eigen::Vector2d centre_m = centre_of(even().terrain, triangle);
    EXPECT_TRUE(std::isinf(
        leaving(even().terrain, triangle, piece_from(even(), triangle, centre_m, Eigen::Vector2d::Zero()))
            .time_s));
    // 1 m/s against 2 m/s2 turns after 25 cm, and the centre lies more than a metre from each edge. The way
    // back leads over the edge behind.
    const RollingPiece back = piece_from(even(), triangle, centre_m, {1.0, 0.0}, {-2.0, 0.0});
    EXPECT_GT(leaving(even().terrain, triangle, back).time_s, 1.0);
}

TEST(EndAtEdge, ShortensOnlyAPieceThatLeaves) {
    const std::uint32_t triangle = under(even(), 500.0, 52.0);
    RollingPiece piece = piece_from(even(), triangle, centre_of(even().terrain, triangle), {3.0, 1.0});
    const Leaving out = leaving(even().terrain, triangle, piece);
    RollingPiece ends_before = piece;
    ends_before.duration_s = 0.5 * out.time_s;
    end_at_edge(ends_before, even().terrain, triangle, out);
    EXPECT_EQ(ends_before.end, RollingEnd::standstill);
    EXPECT_EQ(ends_before.duration_s, 0.5 * out.time_s);
    end_at_edge(piece, even().terrain, triangle, out);
    EXPECT_EQ(piece.end, RollingEnd::edge);
    EXPECT_EQ(piece.duration_s, out.time_s);
    EXPECT_EQ(piece.next_triangle, even().terrain.triangles()[triangle].neighbours[out.edge]);
    EXPECT_EQ(triangle_beyond(even().terrain, piece), piece.next_triangle);
}

/// A piece that reaches the edge to the wall, or to the ground at its foot, after a millisecond.
RollingPiece just_before_an_edge(const Slope& slope, std::uint32_t triangle) {
    const Eigen::Vector2d centre_m = centre_of(slope.terrain, triangle);
    const Eigen::Vector2d velocity_mps{2.0, 0.0};
    const Leaving out = leaving(slope.terrain, triangle, piece_from(slope, triangle, centre_m, velocity_mps));
    return piece_from(slope, triangle, centre_m + (out.time_s - 1e-3) * velocity_mps, velocity_mps);
}

TEST(EndNearEdge, RunsOverTheEdgeALittleOnEvenGround) {
    const std::uint32_t triangle = under(even(), 500.0, 52.0);
    RollingPiece piece = just_before_an_edge(even(), triangle);
    end_near_edge(piece, even().terrain, triangle, even().terrain.plane_of(triangle),
                  leaving(even().terrain, triangle, piece));
    EXPECT_TRUE(piece.ran_over);
    EXPECT_EQ(piece.duration_s, shortest_rolling_piece_s);
    const Eigen::Vector3d end_m = piece.position_m(piece.duration_s);
    EXPECT_EQ(triangle_beyond(even().terrain, piece), even().terrain.locate(end_m.x(), end_m.y()).value());
    EXPECT_NE(triangle_beyond(even().terrain, piece), triangle);
}

TEST(EndNearEdge, EndsAtTheEdgeOfACliff) {
    // The last triangle of the terrace whose way east leads onto the wall, which falls by 4 in 1.
    std::uint32_t triangle = under(terrace(), 94.9, 52.0);
    RollingPiece piece = just_before_an_edge(terrace(), triangle);
    RollingPiece probe = piece;
    end_at_edge(probe, terrace().terrain, triangle, leaving(terrace().terrain, triangle, probe));
    if (terrace().terrain.plane_of(probe.next_triangle).gradient.norm() < 1.0) {
        triangle = probe.next_triangle;  // the other half of the cell lies between
        piece = just_before_an_edge(terrace(), triangle);
    }
    end_near_edge(piece, terrace().terrain, triangle, terrace().terrain.plane_of(triangle),
                  leaving(terrace().terrain, triangle, piece));
    ASSERT_NEAR(terrace().terrain.plane_of(piece.next_triangle).gradient.norm(), 4.0, 1e-6);
    EXPECT_EQ(piece.end, RollingEnd::edge);
    EXPECT_FALSE(piece.ran_over);
    EXPECT_NEAR(piece.duration_s, 1e-3, 1e-9);
}

TEST(CentimetreOn, GoesAStraightCentimetreAtTheLastVelocity) {
    const std::uint32_t triangle = under(even(), 500.0, 52.0);
    RollingPiece run =
        piece_from(even(), triangle, centre_of(even().terrain, triangle), {3.0, 1.0}, {1.0, -0.5});
    run.duration_s = 0.4;
    const RollingPiece on = centimetre_on(run);
    EXPECT_EQ(on.start_m, run.position_m(0.4));
    EXPECT_EQ(on.velocity_mps, run.velocity_at(0.4));
    EXPECT_NEAR((on.position_m(on.duration_s) - on.start_m).norm(), 0.01, 1e-12);
}

}  // namespace
}  // namespace rockfall::leaving_test
