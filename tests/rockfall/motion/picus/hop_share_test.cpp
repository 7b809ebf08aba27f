#include "rockfall/motion/picus/hop_share.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "config/units/constants.hpp"

namespace rockfall::picus::hop_share_test {
namespace {

/// Length along a plane of a hop that leaves at `angle_rad` above it, from the parabola itself.
double hop_length_m(double speed_mps, double angle_rad, double slope_rad) {
    const double g_normal = config::gravity_mps2 * std::cos(slope_rad);
    const double g_along = config::gravity_mps2 * std::sin(slope_rad);
    const double flight_s = 2.0 * speed_mps * std::sin(angle_rad) / g_normal;
    return speed_mps * std::cos(angle_rad) * flight_s + 0.5 * g_along * flight_s * flight_s;
}

RC_GTEST_PROP(HopShare, IsTheRatioOfHopsOnAPlane, ()) {
    const auto number = [](double low, double high) {
        return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) * 1e-6;
    };
    const double slope_rad = number(0.0, 1.2);
    const double angle_rad = number(0.05, 1.0);
    const double usual_rad = number(0.05, 1.0);
    const double speed_mps = number(1.0, 40.0);
    const Eigen::Vector3d normal{std::sin(slope_rad), 0.0, std::cos(slope_rad)};
    const Eigen::Vector3d downhill{std::cos(slope_rad), 0.0, -std::sin(slope_rad)};
    const Eigen::Vector3d leaving_mps =
        speed_mps * (std::cos(angle_rad) * downhill + std::sin(angle_rad) * normal);
    const double exact =
        hop_length_m(speed_mps, angle_rad, slope_rad) / hop_length_m(speed_mps, usual_rad, slope_rad);
    RC_ASSERT(std::abs(hop_share(leaving_mps, normal, config::Angle::from_radians(usual_rad)) /
                           std::min(exact, 20.0) -
                       1.0) < 1e-9);
}

TEST(IsStopped, StopsLikeSoManyImpacts) {
    constexpr int draws = 200'000;
    for (const double impacts : {0.4, 1.0, 2.5}) {
        int stopped = 0;
        for (std::uint64_t i = 0; i < draws; ++i) {
            const config::RandomStream stream{{3, 0, 0, i}, config::Purpose::test};
            stopped += is_stopped(stream.uniforms_of(0)[0], 0.05, impacts) ? 1 : 0;
        }
        const double expected = 1.0 - std::pow(0.95, impacts);
        const double deviation = std::sqrt(expected * (1.0 - expected) / draws);
        EXPECT_NEAR(stopped / static_cast<double>(draws), expected, 4.0 * deviation) << impacts;
    }
}

TEST(IsStopped, AlwaysWhereEveryImpactStopsAndNeverWhereNoneDoes) {
    EXPECT_TRUE(is_stopped(0.999, 1.0, 0.3));
    EXPECT_FALSE(is_stopped(0.0, 0.0, 3.0));
}

}  // namespace
}  // namespace rockfall::picus::hop_share_test
