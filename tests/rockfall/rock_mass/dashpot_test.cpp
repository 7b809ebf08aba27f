// Dashpots of contacts: what they take at any step, and of blocks that tilt.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/rockfall/rock_mass/scenes.hpp"

namespace rockfall::rock_mass {
namespace {

using namespace scenes;

Laws laws_of_dashpots(double damping_ratio, double step_factor) {
    Laws laws = lossless();
    laws.gravity_mps2 = 9.81;
    laws.damping_ratio = damping_ratio;
    laws.step_factor = step_factor;
    return laws;
}

/// Speed of a cube after it struck the ground with a face, by that before.
double restitution(double step_factor) {
    BlockStart cube = cube_at({0.0, 0.0, 0.55}, 1.0);
    cube.velocity_mps = {0.0, 0.0, -5.0};
    Laws laws = laws_of_dashpots(0.5, step_factor);
    laws.modulus_pa = 1e7;
    RockMass mass{laws, std::vector{cube}, {}, Ground{plane_of(0.0)}};
    double up_mps = 0.0;
    while (mass.time_s() < 0.6) {
        mass.step();
        up_mps = std::max(up_mps, mass.blocks()[0].velocity_mps.z());
    }
    return up_mps / 5.0;
}

TEST(Dashpots, TakeAboutTheSameAtLongSteps) {
    // With the velocity of half a step ago as it is, 0.233 at 0.4. At 0.5, the longest, nothing is gained:
    // 0.326, and 0.268 without the share.
    const double exact = restitution(0.01);
    EXPECT_NEAR(exact, 0.298, 0.005);
    for (const double step_factor : {0.05, 0.1, 0.2, 0.3, 0.4}) {
        EXPECT_NEAR(restitution(step_factor), exact, 0.025) << step_factor;
    }
    EXPECT_NEAR(restitution(0.5), exact, 0.035);
}

TEST(Dashpots, TakeTheMotionOfABlockThatRocksOnItsFace) {
    // Spread as the pressure is, a dashpot of beta of the critical one against a shift is one of beta p
    // sqrt(m / I) of it against a tilt; p^2 is a twelfth of the square of the side, I / m that with the
    // square of the height. Half a period takes exp(-pi zeta / sqrt(1 - zeta^2)).
    constexpr double side_m = 4.0, damping_ratio = 0.05;
    const double zeta = damping_ratio * side_m / std::hypot(side_m, 1.0);
    const Laws laws = laws_of_dashpots(damping_ratio, 0.05);
    const Ground ground{plane_of(0.0)};
    BlockStart slab = block_of(
        solids::placed(solids::box({side_m, side_m, 1.0}), Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.5}),
        2500.0, false);
    RockMass held{laws, std::vector{slab}, {}, ground};
    held.hold();
    held.advance(static_cast<std::uint64_t>(3.0 / held.step_s()));
    slab.centre_m = held.blocks()[0].centre_m;
    const Vector3d spin_radps{1e-4, 0.0, 0.0};
    slab.momentum_nms = slab.solid.inertia_kgm2.cwiseProduct(slab.attitude.conjugate() * spin_radps);
    RockMass mass{laws, std::vector{slab}, {}, ground};
    std::vector<double> peaks_radps{0.0};
    double before_radps = spin_radps.x();
    while (peaks_radps.size() < 8) {
        mass.step();
        const double now_radps = mass.blocks()[0].spin_radps().x();
        if ((now_radps > 0.0) != (before_radps > 0.0)) {
            peaks_radps.push_back(0.0);
        }
        peaks_radps.back() = std::max(peaks_radps.back(), std::abs(now_radps));
        before_radps = now_radps;
    }
    const double half_period = std::exp(-std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta));
    for (std::size_t k = 2; k + 1 < peaks_radps.size(); ++k) {
        EXPECT_NEAR(peaks_radps[k] / peaks_radps[k - 1], half_period, 0.005) << k;
    }
}

TEST(Dashpots, LeaveABlockThatLeansOnTwoPlacesNoMotion) {
    // A slab with one end on a cube: it turns about the line through both contacts, of which their middles
    // see nothing.
    const Eigen::Quaterniond lean{Eigen::AngleAxisd{0.35, Vector3d::UnitY()} *
                                  Eigen::AngleAxisd{0.02, Vector3d::UnitX()}};
    BlockStart slab =
        block_of(solids::placed(solids::box({3.0, 1.0, 0.5}), lean, {1.62, 0.0, 0.83}), 2500.0, false);
    Laws laws = laws_of_dashpots(0.5, 0.2);
    laws.modulus_pa = 1e7;
    laws.friction = laws.ground_friction = 0.6;
    RockMass mass{
        laws, std::vector{slab, cube_at({0.0, 0.0, 0.5}, 1.0, 2500.0, true)}, {}, Ground{plane_of(0.0)}};
    double energy_j = 0.0;
    for (const double until_s : {2.0, 8.0}) {
        while (mass.time_s() < until_s) {
            mass.step();
        }
        energy_j = mass.blocks()[0].energy_j();
    }
    EXPECT_LT(energy_j, 1e-4);
    EXPECT_GT(mass.blocks()[0].centre_m.z(), 0.5) << "it still leans";
    EXPECT_LT(std::abs(residual_share(mass)), 0.02);
}

}  // namespace
}  // namespace rockfall::rock_mass
