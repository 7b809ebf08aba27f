// The laws that are off by default: scars, and what unity_compat switches on.

#include <gtest/gtest.h>

#include <cmath>

#include "rockfall/motion/rigid/scarring.hpp"
#include "tests/rockfall/motion/rigid/scene.hpp"

namespace rockfall::rigid::testing {
namespace {

/// As `rockfall.preset = unity_compat` sets them.
Law unity_law() {
    Law law = law_of(0.5 * std::tan(radians(35.0)), 0.0);
    law.double_friction = true;
    law.spin_cap_radps = 7.0;
    return law;
}

double lying_way_m(const Law& law, double slope_deg, double time_s) {
    const Slope slope = plane(slope_deg, 200.0);
    const solids::Solid solid = cube();
    return way_m(slope, law, solid, lying(slope, solid, slope_deg, 20.0, 10.0), time_s);
}

TEST(UnityCompat, CountsFrictionTwiceUnderAFace) {
    constexpr double time_s = 2.0;
    EXPECT_LT(lying_way_m(unity_law(), 34.0, time_s), 1e-3)
        << "holds below the angle of friction of 35 degrees";
    const double slides_mps2 =
        config::gravity_mps2 * (std::sin(radians(37.0)) - std::tan(radians(35.0)) * std::cos(radians(37.0)));
    EXPECT_NEAR(lying_way_m(unity_law(), 37.0, time_s), 0.5 * slides_mps2 * time_s * time_s, 1e-3);
}

TEST(UnityCompat, CapsTheSpinAndBooksWhatThatTakes) {
    const Slope slope = plane(38.0, 400.0);
    const solids::Solid ball = solids::ball_of(0.5, 2700.0);
    const Body start = lying(slope, ball, 38.0, 20.0, 10.0);
    const auto triangle = slope.terrain.locate(20.0, 10.0).value();
    BlockScratch scratch;
    Law law = unity_law();
    Block capped{slope, law, ball, start, triangle, scratch};
    const Body end = moved(capped, law, 4.0, true);
    EXPECT_NEAR(end.spin_radps(ball).norm(), 7.0, 0.5);
    EXPECT_LT(std::abs(capped.residual_j()), 1e-3 * capped.ledger().dissipated_j());

    law.spin_cap_radps = 0.0;
    Block free{slope, law, ball, start, triangle, scratch};
    EXPECT_GT(moved(free, law, 4.0, true).spin_radps(ball).norm(), 30.0);
}

}  // namespace
}  // namespace rockfall::rigid::testing
