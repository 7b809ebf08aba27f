#include "rockfall/motion/rigid/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockfall::rigid {
namespace {

using Eigen::Vector3d;

double spread(const solids::Rotation& a, const solids::Rotation& b) {
    return (a.attitude.toRotationMatrix() - b.attitude.toRotationMatrix()).cwiseAbs().maxCoeff();
}

TEST(Turning, KeepsMomentumAndEnergyForFiveMinutesAboutEachAxis) {
    for (const Vector3d& inertia :
         {Vector3d{2.0, 3.0, 4.0}, Vector3d{2.0, 2.0, 3.0}, Vector3d{2.0, 3.0, 3.0}}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vector3d spin{0.01, 0.01, 0.01};
            spin[axis] = 5.0;
            const solids::Rotation start{Eigen::Quaterniond{0.5, 0.5, -0.5, 0.5}, inertia.cwiseProduct(spin)};
            Turning turning{inertia};
            turning.begin(start);
            const solids::Rotation end = turning.at(300.0);
            const Vector3d before = start.momentum_in_space_nms(), after = end.momentum_in_space_nms();
            EXPECT_NEAR(end.momentum_nms.norm(), start.momentum_nms.norm(), 1e-12 * before.norm()) << axis;
            EXPECT_LT((after - before).norm(), 1e-12 * before.norm()) << axis;
            EXPECT_NEAR(end.energy_j(inertia), start.energy_j(inertia), 1e-4 * start.energy_j(inertia))
                << axis;
        }
    }
}

TEST(Turning, ClosedFormOfATopIsThatOfSmallSteps) {
    const Vector3d inertia{2.0, 2.0, 3.0};
    const solids::Rotation start{Eigen::Quaterniond{0.8, 0.2, 0.4, 0.4}.normalized(), {3.0, -4.0, 6.0}};
    Turning turning{inertia};
    turning.begin(start);
    solids::Rotation stepped = start;
    for (int i = 0; i < 4000; ++i) {
        stepped = solids::rotate_free(stepped, inertia, 0.5e-3);
    }
    EXPECT_LT(spread(turning.at(2.0), stepped), 1e-6);
}

TEST(Turning, DoesNotDependOnTheTimesAskedForBefore) {
    const Vector3d inertia{2.0, 3.0, 4.5};
    const solids::Rotation start{Eigen::Quaterniond::Identity(), {3.0, -4.0, 6.0}};
    Turning asked{inertia}, direct{inertia};
    asked.begin(start);
    direct.begin(start);
    for (const double time_s : {0.1, 0.3, 0.9, 0.4}) {
        asked.at(time_s);
    }
    EXPECT_EQ(spread(asked.at(0.7), direct.at(0.7)), 0.0);
}

}  // namespace
}  // namespace rockfall::rigid
