#include "rockfall/motion/rigid/percussion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "config/random/stream.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double body_kg = 10.0;
constexpr double body_radius_m = 0.5;
const double ball_inertia = 0.4 * body_kg * body_radius_m * body_radius_m;

BlockMass ball_mass() {
    return {1.0 / body_kg, Matrix3d::Identity() / ball_inertia};
}

double energy_of_motion_j(const BlockMass& mass, const Velocities& v) {
    return 0.5 * v.linear_mps.squaredNorm() / mass.inverse_mass_pkg +
           0.5 * v.spin_radps.dot(mass.inverse_inertia.inverse() * v.spin_radps);
}

/// Oblique impact of a sphere (Brach 1991): v_n+ = -e v_n; it slips if mu < 2/7 |v_t| / ((1 + e) v_n).
TEST(PercussionOfASphere, FollowsTheClosedFormOfObliqueImpact) {
    for (const double e : {0.0, 0.4, 1.0}) {
        for (const double friction : {0.05, 0.2, 0.9}) {
            const Velocities before{{6.0, 2.0, -5.0}, {0.5, -1.0, 3.0}};
            const PercussionPoint point{{0.0, 0.0, -body_radius_m}, Vector3d::UnitZ(), friction, e};
            PercussionSolver solver{SolverLaw{}};
            const PercussionResult result =
                solver.solve(ball_mass(), before, Vector3d::Zero(), std::span{&point, 1}, 0.0);

            const Vector3d slip = before.at(point.arm_m) - Vector3d{0.0, 0.0, -5.0};
            const double normal_ns = body_kg * (1.0 + e) * 5.0;
            const double stick_ns = 2.0 / 7.0 * body_kg * slip.norm();
            const Vector3d impulse =
                -std::min(stick_ns, friction * normal_ns) * slip.normalized() + normal_ns * Vector3d::UnitZ();
            const Vector3d linear = before.linear_mps + impulse / body_kg;
            const Vector3d spin = before.spin_radps + point.arm_m.cross(impulse) / ball_inertia;
            EXPECT_LT((result.after.linear_mps - linear).norm(), 1e-8) << e << " " << friction;
            EXPECT_LT((result.after.spin_radps - spin).norm(), 1e-8) << e << " " << friction;
            EXPECT_NEAR(
                result.normal_work_j + result.tangential_work_j,
                energy_of_motion_j(ball_mass(), result.after) - energy_of_motion_j(ball_mass(), before),
                1e-8);
        }
    }
}

/// A disc is a body with the moment m r^2 / 2 about its axis: sticking takes a third of the slip's impulse.
TEST(PercussionOfADisc, SticksWithAThirdOfTheSlip) {
    Matrix3d inverse = Matrix3d::Identity() / (0.25 * body_kg * body_radius_m * body_radius_m);
    inverse(1, 1) = 1.0 / (0.5 * body_kg * body_radius_m * body_radius_m);
    const BlockMass disc{1.0 / body_kg, inverse};
    const Velocities before{{3.0, 0.0, -4.0}, Vector3d::Zero()};
    const PercussionPoint point{{0.0, 0.0, -body_radius_m}, Vector3d::UnitZ(), 0.5, 0.5};
    PercussionSolver solver{SolverLaw{}};
    const auto after = solver.solve(disc, before, Vector3d::Zero(), std::span{&point, 1}, 0.0).after;
    EXPECT_NEAR(after.linear_mps.x(), 2.0, 1e-8);
    EXPECT_NEAR(after.linear_mps.z(), 2.0, 1e-8);
    EXPECT_NEAR(after.at(point.arm_m).x(), 0.0, 1e-8);
}

TEST(Percussions, NeverRaiseTheEnergyAndHoldCoulombsLaw) {
    for (std::uint64_t trial = 0; trial < 400; ++trial) {
        config::RandomStream chance{{11, 0, 0, trial}, config::Purpose::test};
        const auto vector = [&] {
            const double x = chance.uniform(), y = chance.uniform(), z = chance.uniform();
            return Vector3d{2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * z - 1.0};
        };
        const Vector3d moments = 0.2 * Vector3d::Ones() + vector().cwiseAbs();
        const Matrix3d turn = Eigen::Quaterniond{chance.uniform(), chance.uniform(), chance.uniform(), 0.1}
                                  .normalized()
                                  .toRotationMatrix();
        const BlockMass mass{1.0 / body_kg, turn * moments.cwiseInverse().asDiagonal() * turn.transpose()};
        const Velocities before{5.0 * vector() - Vector3d{0.0, 0.0, 5.0}, 10.0 * vector()};
        std::vector<PercussionPoint> points;
        const int count = 1 + static_cast<int>(4.0 * chance.uniform());
        const double friction = chance.uniform(), e = chance.uniform();
        for (int i = 0; i < count; ++i) {
            points.push_back({0.4 * vector() - Vector3d{0.0, 0.0, 0.3},
                              (0.3 * vector() + Vector3d::UnitZ()).normalized(), friction, e,
                              static_cast<std::uint32_t>(i)});
        }
        for (const ImpactLaw law : {ImpactLaw::newton, ImpactLaw::poisson}) {
            SolverLaw settings;
            settings.impact = law;
            PercussionSolver solver{settings};
            const PercussionResult result = solver.solve(mass, before, Vector3d::Zero(), points, 0.0);
            EXPECT_LE(energy_of_motion_j(mass, result.after), energy_of_motion_j(mass, before) * (1.0 + 1e-9))
                << trial;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Percussion& p = solver.percussions()[i];
                EXPECT_GE(p.normal_ns, -1e-9);
                const Vector3d along = p.impulse_ns - p.normal_ns * points[i].normal;
                EXPECT_LE(along.norm(), friction * p.normal_ns + 1e-7);
                if (result.converged) {
                    EXPECT_GE(result.after.at(points[i].arm_m).dot(points[i].normal), -1e-7) << trial;
                }
            }
        }
    }
}

}  // namespace
}  // namespace rockfall::rigid
