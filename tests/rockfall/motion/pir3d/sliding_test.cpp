#include "rockfall/motion/pir3d/sliding.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/terrain/face.hpp"
#include "tests/rockfall/slopes.hpp"

namespace rockfall::pir3d::sliding_test {
namespace {

using rockfall::testing::EventLog;
using rockfall::testing::logged_fall;
using rockfall::testing::plane_slope;
using rockfall::testing::sliding_law;
using rockfall::testing::start_at;
using rockfall::testing::test_soil;

constexpr double g = 9.81;

/// The exact path of a point that slides on an inclined plane, by u = tan(psi / 2), psi being the angle from
/// the fall line: v = C u^kappa (1 + u^2) / (2 u) with kappa = k / tan b; time and place are its integrals in
/// closed form. x lies down the fall line, y across.
class Hodograph {
public:
    Hodograph(double slope_deg, double friction, double speed_mps, double psi_rad)
        : along_{g * std::sin(slope_deg * M_PI / 180.0)},
          kappa_{friction / std::tan(slope_deg * M_PI / 180.0)},
          first_{std::tan(0.5 * psi_rad)},
          constant_{speed_mps * 2.0 * first_ / std::pow(first_, kappa_) / (1.0 + first_ * first_)} {}

    [[nodiscard]] Eigen::Vector2d place_at(double time_s) const {
        return place(u_at(time_s)) - place(first_);
    }
    [[nodiscard]] double speed_at(double time_s) const {
        const double u = u_at(time_s);
        return 0.5 * constant_ * (std::pow(u, kappa_ - 1.0) + std::pow(u, kappa_ + 1.0));
    }

private:
    [[nodiscard]] double time(double u) const {
        return -0.5 * constant_ / along_ *
               (std::pow(u, kappa_ - 1.0) / (kappa_ - 1.0) + std::pow(u, kappa_ + 1.0) / (kappa_ + 1.0));
    }
    [[nodiscard]] double u_at(double time_s) const {
        double low = 1e-12, high = first_;  // time rises as u falls
        for (int i = 0; i < 200; ++i) {
            const double middle = std::sqrt(low * high);
            (time(middle) - time(first_) < time_s ? high : low) = middle;
        }
        return high;
    }
    [[nodiscard]] Eigen::Vector2d place(double u) const {
        const double scale = -0.25 * constant_ * constant_ / along_;
        return {scale * (std::pow(u, 2.0 * kappa_ - 2.0) / (2.0 * kappa_ - 2.0) -
                         std::pow(u, 2.0 * kappa_ + 2.0) / (2.0 * kappa_ + 2.0)),
                2.0 * scale *
                    (std::pow(u, 2.0 * kappa_ - 1.0) / (2.0 * kappa_ - 1.0) +
                     std::pow(u, 2.0 * kappa_ + 1.0) / (2.0 * kappa_ + 1.0))};
    }
    double along_, kappa_, first_, constant_;
};

struct Frame {
    Eigen::Vector3d normal, down, across = Eigen::Vector3d::UnitY();
    explicit Frame(double slope_deg) {
        const double b = slope_deg * M_PI / 180.0;
        normal = {std::sin(b), 0.0, std::cos(b)};
        down = {std::cos(b), 0.0, -std::sin(b)};
    }
    [[nodiscard]] Eigen::Vector3d velocity(double speed_mps, double psi_rad) const {
        return speed_mps * (std::cos(psi_rad) * down + std::sin(psi_rad) * across);
    }
};

Slope even_slope(double slope_deg, double friction) {
    Slope slope = plane_slope(slope_deg, {0.3, 0.75}, 0.0, 2000.0, 400.0);
    slope.types[0].soil = test_soil(friction);
    return slope;
}

constexpr double psi_rad = 1.4;

TEST(NystromStep, IsOfFourthOrder) {
    // Halving the step divides the error at a given time by 2^4.
    const Frame frame{35.0};
    const Hodograph exact{35.0, 0.6, 8.0, psi_rad};
    const auto acceleration = [&](const Eigen::Vector3d&, const Eigen::Vector3d& v) {
        return sliding_acceleration(frame.normal, v.normalized(), 0.6);
    };
    constexpr double until_s = 1.6;
    std::vector<double> errors;
    for (const int steps : {4, 8, 16, 32}) {
        PointState state{Eigen::Vector3d::Zero(), frame.velocity(8.0, psi_rad)};
        for (int i = 0; i < steps; ++i) {
            state = nystrom_step(state, until_s / steps, acceleration).end;
        }
        const Eigen::Vector2d place{state.position_m.dot(frame.down), state.position_m.dot(frame.across)};
        errors.push_back((place - exact.place_at(until_s)).norm());
    }
    for (std::size_t i = 1; i < errors.size(); ++i) {
        const double order = std::log2(errors[i - 1] / errors[i]);
        std::printf("%2d steps of %.2f s: error %.2e m, order %.2f\n", 4 << i, until_s / (4 << i), errors[i],
                    order);
        EXPECT_NEAR(order, 4.0, 0.5);
    }
}

TEST(NystromStep, EstimatesItsErrorBySecondDifferences) {
    // A constant acceleration is integrated exactly, and the estimate says so.
    const auto fall = [](const Eigen::Vector3d&, const Eigen::Vector3d&) {
        return Eigen::Vector3d{0.0, 0.0, -g};
    };
    const NystromStep step = nystrom_step({{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}}, 2.0, fall);
    EXPECT_NEAR((step.end.position_m - Eigen::Vector3d{2.0, 4.0, 6.0 - 2.0 * g}).norm(), 0.0, 1e-12);
    EXPECT_EQ(step.error_m, 0.0);
}

TEST(SlidingStep, KeepsToItsTolerance) {
    const Frame frame{35.0};
    const Hodograph exact{35.0, 0.6, 2.0, 2.6};
    double last_s = 10.0;
    for (const double tolerance_m : {1e-1, 1e-3, 1e-6}) {
        const SlidingStep step = sliding_step({Eigen::Vector3d::Zero(), frame.velocity(2.0, 2.6)},
                                              frame.normal, 0.6, 1.0, tolerance_m);
        const Eigen::Vector2d place{step.end.position_m.dot(frame.down),
                                    step.end.position_m.dot(frame.across)};
        EXPECT_LT((place - exact.place_at(step.duration_s)).norm(), tolerance_m);
        EXPECT_LT(step.duration_s, last_s);
        last_s = step.duration_s;
    }
}

TEST(Sliding, FollowsTheHodographToACentimetreIn100Metres) {
    for (const double start_rad : {0.4, 1.4, 2.6}) {
        for (const auto& [slope_deg, friction] : {std::pair{35.0, 0.6}, std::pair{45.0, 0.8}}) {
            const Slope slope = even_slope(slope_deg, friction);
            const Frame frame{slope_deg};
            const Hodograph exact{slope_deg, friction, 9.0, start_rad};
            const RockStart start = start_at(slope, 300.0, 50.0, 0.0, frame.velocity(9.0, start_rad));
            const auto [end, log] = logged_fall(slope, sliding_law(), start);
            double time_s = 0.0;
            double way_m = 0.0;
            double largest_m = 0.0;
            for (const EventLog::Roll& roll : log.rolls) {
                const Eigen::Vector3d moved = roll.piece.start_m - start.position_m;
                const Eigen::Vector2d place{moved.dot(frame.down), moved.dot(frame.across)};
                largest_m = std::max(largest_m, (place - exact.place_at(time_s)).norm());
                EXPECT_NEAR(roll.piece.velocity_mps.norm(), exact.speed_at(time_s), 5e-3);
                // Within a step maps and trees see a parabola: a millimetre off the path at most.
                const double half_s = 0.5 * roll.piece.duration_s;
                const Eigen::Vector3d half = roll.piece.position_m(half_s) - roll.piece.start_m;
                const Eigen::Vector2d on_parabola{half.dot(frame.down), half.dot(frame.across)};
                const Eigen::Vector2d on_path = exact.place_at(time_s + half_s) - exact.place_at(time_s);
                EXPECT_LT((on_parabola - on_path).norm(), 1e-3);
                time_s += roll.piece.duration_s;
                way_m += (roll.piece.position_m(roll.piece.duration_s) - roll.piece.start_m).norm();
                if (way_m > 100.0) {
                    break;
                }
            }
            EXPECT_GT(way_m, 100.0);
            EXPECT_LT(largest_m, 1e-2) << slope_deg << " degrees, " << start_rad << " rad";
        }
    }
}

TEST(Sliding, LosesExactlyTheWorkOfFriction) {
    constexpr double slope_deg = 35.0, friction = 0.6;
    const Slope slope = even_slope(slope_deg, friction);
    const Frame frame{slope_deg};
    const RockStart start = start_at(slope, 300.0, 50.0, 0.0, frame.velocity(9.0, psi_rad));
    const auto [end, log] = logged_fall(slope, sliding_law(), start);
    ASSERT_GT(log.rolls.size(), 50U);
    double work = 0.0;  // of friction, by mass; Simpson's rule on the speed along each step
    for (std::size_t i = 0; i + 1 < log.rolls.size(); ++i) {
        const RollingPiece& piece = log.rolls[i].piece;
        const double h = piece.duration_s;
        const double way_m = h / 6.0 *
                             (piece.velocity_mps.norm() + 4.0 * piece.velocity_at(0.5 * h).norm() +
                              piece.velocity_at(h).norm());
        work += friction * g * frame.normal.z() * way_m;
        const RollingPiece& next = log.rolls[i + 1].piece;
        const double gained = 0.5 * (next.velocity_mps.squaredNorm() - start.velocity_mps.squaredNorm());
        EXPECT_NEAR(gained + work, g * (start.position_m.z() - next.start_m.z()), 1e-4 * work + 1e-9);
    }
}

TEST(Sliding, StopsWhereTheClosedFormSaysAndCountsNoSpin) {
    // v^2 / (2 g (k cos b - sin b)) on ground below the friction angle.
    const Slope slope = even_slope(20.0, 0.6);
    const Frame frame{20.0};
    const RockStart start = start_at(slope, 300.0, 50.0, 0.0, frame.velocity(5.0, 0.0));
    const auto [end, log] = logged_fall(slope, sliding_law(), start);
    EXPECT_EQ(end.reason, StopReason::at_rest);
    EXPECT_NEAR((end.position_m - start.position_m).norm(),
                25.0 / (2.0 * g * (0.6 * frame.normal.z() + frame.down.z())), 1e-4);
    EXPECT_TRUE(log.rolls[0].piece.slides);
}

TEST(Sliding, ComesToRestWhereFrictionIsJustEnoughInsteadOfCreeping) {
    // Across a slope below the friction angle the motion turns into the fall line as it dies away, ever
    // faster against its speed. Followed here by the same equation in steps of a thousandth of that time.
    for (const double slope_deg : {25.0, 30.0, 30.5}) {
        for (const double diameter_m : {0.1, 1.0}) {
            const Slope slope = even_slope(slope_deg, 0.6);
            const Frame frame{slope_deg};
            const RockStart start = start_at(slope, 300.0, 150.0, 0.0, frame.velocity(4.0, 1.2), diameter_m);
            Eigen::Vector3d place = start.position_m;
            Eigen::Vector3d velocity = start.velocity_mps;
            double exact_s = 0.0;
            while (velocity.norm() > 1e-4) {
                const double step_s = 1e-3 * velocity.norm() / (0.6 * g * frame.normal.z());
                const Eigen::Vector3d half =
                    velocity + 0.5 * step_s * sliding_acceleration(frame.normal, velocity.normalized(), 0.6);
                velocity += step_s * sliding_acceleration(frame.normal, half.normalized(), 0.6);
                place += step_s * half;
                exact_s += step_s;
            }
            const auto [end, log] = logged_fall(slope, sliding_law(), start);
            double duration_s = 0.0;
            for (const EventLog::Roll& roll : log.rolls) {
                duration_s += roll.piece.duration_s;
            }
            EXPECT_EQ(end.reason, StopReason::at_rest) << slope_deg;
            EXPECT_LT((end.position_m - place).norm(), 0.01) << slope_deg;
            EXPECT_NEAR(duration_s, exact_s, 0.01 * exact_s) << slope_deg;
            EXPECT_LT(log.rolls.size(), 1000U) << slope_deg;
        }
    }
}

TEST(Sliding, TurnsBackUphillOnlyAboveTheFrictionAngle) {
    // atan(0.6) = 30.96 degrees. Uphill friction and slope brake together: v^2 / (2 g (k cos b + sin b)).
    for (const auto& [slope_deg, turns] : {std::pair{30.5, false}, std::pair{31.5, true}}) {
        const Slope slope = even_slope(slope_deg, 0.6);
        const Frame frame{slope_deg};
        const RockStart start = start_at(slope, 300.0, 50.0, 0.0, frame.velocity(-6.0, 0.0));
        const auto [end, log] = logged_fall(slope, sliding_law(), start);
        const double highest_m = 36.0 / (2.0 * g * (0.6 * frame.normal.z() - frame.down.z()));
        double reached_m = 0.0;
        for (const EventLog::Roll& roll : log.rolls) {
            reached_m = std::max(
                reached_m, (start.position_m - roll.piece.position_m(roll.piece.duration_s)).dot(frame.down));
        }
        EXPECT_NEAR(reached_m, highest_m, 1e-4) << slope_deg;
        EXPECT_EQ(end.reason == StopReason::left_terrain, turns) << slope_deg << " degrees";
    }
}

TEST(Sliding, EndsAtTheEdgeOfItsTriangle) {
    const Slope slope = even_slope(35.0, 0.6);
    const Frame frame{35.0};
    const RockStart start = start_at(slope, 302.0, 51.0, 0.0, frame.velocity(9.0, psi_rad));
    PointState state{start.position_m, start.velocity_mps};
    const Plane plane = slope.terrain.plane_of(start.triangle);
    for (int i = 0; i < 100; ++i) {
        const SlidingPiece piece = slide(slope.terrain, start.triangle, Face{plane}, state.position_m,
                                         state.velocity_mps, 0.6, 1e-3);
        state = {piece.position_m(piece.duration_s), piece.velocity_at(piece.duration_s)};
        if (piece.end == RollingEnd::edge) {
            const Triangle& t = slope.terrain.triangles()[start.triangle];
            double nearest_m = 1e9;
            for (int k = 0; k < 3; ++k) {
                const Vertex& a = slope.terrain.vertices()[t.corners[k]];
                const Vertex& b = slope.terrain.vertices()[t.corners[(k + 1) % 3]];
                const Eigen::Vector2d along = Eigen::Vector2d{b.x_m - a.x_m, b.y_m - a.y_m}.normalized();
                const Eigen::Vector2d to = state.position_m.head<2>() - Eigen::Vector2d{a.x_m, a.y_m};
                nearest_m = std::min(nearest_m, std::abs(along.x() * to.y() - along.y() * to.x()));
            }
            EXPECT_LT(nearest_m, 2e-6);
            return;
        }
    }
    FAIL() << "never left its triangle";
}

}  // namespace
}  // namespace rockfall::pir3d::sliding_test
