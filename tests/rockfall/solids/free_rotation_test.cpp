#include "rockfall/solids/free_rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockfall::solids::free_rotation_test {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const Quaterniond oblique = Quaterniond{0.3, -0.5, 0.7, 0.4}.normalized();

TEST(FreeRotation, KeepsMomentumAndEnergyForFiveMinutes) {
    const Vector3d inertia{1.0, 2.0, 2.6};
    for (int axis = 0; axis < 3; ++axis) {
        // 6 rad/s about one axis, with a small push out of it.
        Vector3d spin = Vector3d::Constant(0.01);
        spin[axis] = 6.0;
        const Rotation start{oblique, inertia.cwiseProduct(spin)};
        const Rotation end = rotate_free(start, inertia, 300.0);
        EXPECT_NEAR(end.momentum_nms.norm() / start.momentum_nms.norm(), 1.0, 1e-12);
        EXPECT_LT((end.momentum_in_space_nms() - start.momentum_in_space_nms()).norm(),
                  1e-11 * start.momentum_nms.norm());
        EXPECT_NEAR(end.energy_j(inertia) / start.energy_j(inertia), 1.0, 1e-4);
        EXPECT_NEAR(end.attitude.norm(), 1.0, 1e-14);
    }
}

TEST(FreeRotation, TumblesAboutTheMiddleAxisOnly) {
    const Vector3d inertia{1.0, 2.0, 2.6};
    for (int axis = 0; axis < 3; ++axis) {
        Vector3d spin = Vector3d::Constant(0.01);
        spin[axis] = 6.0;
        Rotation rotation{Quaterniond::Identity(), inertia.cwiseProduct(spin)};
        double lowest = 1.0;
        for (int i = 0; i < 300; ++i) {
            rotation = rotate_free(rotation, inertia, 0.1);
            lowest = std::min(lowest, rotation.momentum_nms[axis] / rotation.momentum_nms.norm());
        }
        if (axis == 1) {
            EXPECT_LT(lowest, -0.99);
        } else {
            EXPECT_GT(lowest, 0.99);
        }
    }
}

TEST(FreeRotation, OfASymmetricBodyPrecessesAsInClosedForm) {
    // I1 = I2: in the body the momentum turns about axis 3 at (1 - I3/I1) times the spin about it, in space
    // the body turns about the momentum at |L| / I1 (Landau & Lifshitz, Mechanics, 33).
    const Vector3d inertia{2.0, 2.0, 3.0};
    const Rotation start{Quaterniond::Identity(), inertia.cwiseProduct(Vector3d{1.0, 0.0, 4.0})};
    const double time_s = 2.0;
    const Rotation end = rotate_free(start, inertia, time_s);

    const double body_turn = (1.0 / inertia[0] - 1.0 / inertia[2]) * start.momentum_nms[2] * time_s;
    const Eigen::AngleAxisd precession{start.momentum_nms.norm() / inertia[0] * time_s,
                                       start.momentum_nms.normalized()};
    const Eigen::AngleAxisd own{-body_turn, Vector3d::UnitZ()};
    const Quaterniond exact = Quaterniond{precession} * Quaterniond{own};
    // The scheme is of second order: (0.02 rad)^2 / 24 a step of turn, 12 rad of turn.
    EXPECT_LT(exact.angularDistance(end.attitude), 12.0 * 0.02 * 0.02 / 12.0);
    const Vector3d exact_momentum = exact.conjugate() * start.momentum_nms;
    EXPECT_LT((exact_momentum - end.momentum_nms).norm(), 1e-3 * exact_momentum.norm());
}

TEST(FreeRotation, AtRestStaysAsItIs) {
    const Rotation still{oblique, Vector3d::Zero()};
    const Rotation end = rotate_free(still, {1.0, 2.0, 3.0}, 10.0);
    EXPECT_EQ(end.momentum_nms, Vector3d::Zero());
    EXPECT_LT(end.attitude.angularDistance(oblique), 1e-15);
}

}  // namespace
}  // namespace rockfall::solids::free_rotation_test
