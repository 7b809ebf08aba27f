#include "rockfall/obstacles/nets/net_impact.hpp"

#include <gtest/gtest.h>

namespace rockfall::net_impact_test {
namespace {

const Rock rock = Rock::sphere(1.0, 2700.0);
const Net net{{{0.0, 0.0}, {10.0, 0.0}}, 3.0, 1.2, 500e3};

TEST(MeetNet, LetsARockPassOverThatHasItsCentreAboveTheUpperEdge) {
    EXPECT_EQ(meet_net(net, rock, 2.51, 1.0), NetOutcome::over);
    EXPECT_EQ(meet_net(net, rock, 2.49, 1.0), NetOutcome::held);
}

TEST(MeetNet, LetsARockPassBelowThatFitsWhollyUnderTheLowerEdge) {
    EXPECT_EQ(meet_net(net, rock, 0.2, 1.0), NetOutcome::below);
    EXPECT_EQ(meet_net(net, rock, 0.21, 1.0), NetOutcome::held);
}

TEST(MeetNet, BreaksUnderMoreThanItsCapacity) {
    EXPECT_EQ(meet_net(net, rock, 1.0, 500e3), NetOutcome::held);
    EXPECT_EQ(meet_net(net, rock, 1.0, 500.001e3), NetOutcome::broke);
}

TEST(SpeedFactorBehind, LeavesTheEnergyAboveTheCapacity) {
    const double factor = speed_factor_behind(net, 800e3);
    EXPECT_NEAR(factor * factor * 800e3, 300e3, 1e-6);
}

}  // namespace
}  // namespace rockfall::net_impact_test
