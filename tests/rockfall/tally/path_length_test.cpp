#include "rockfall/tally/path_length.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "config/random/stream.hpp"

namespace rockfall::path_length_test {
namespace {

using config::gravity_mps2;

Flight flight_of(double plan_mps, double rising_mps) {
    return {Eigen::Vector3d::Zero(), {0.6 * plan_mps, -0.8 * plan_mps, rising_mps}};
}

/// Integral of the speed over time by quadrature, from the top of the parabola both ways: there the speed of
/// a steep flight turns sharply.
double by_quadrature_m(const Flight& flight, double until_s) {
    boost::math::quadrature::tanh_sinh<double> integrator{18};
    const double top_s = std::clamp(flight.velocity_mps.z() / gravity_mps2, 0.0, until_s);
    const auto from_top_to = [&](double end_s) {
        const auto speed = [&](double share) {
            return std::sqrt(flight.squared_speed_at(top_s + share * (end_s - top_s)));
        };
        return std::abs(end_s - top_s) * integrator.integrate(speed, 0.0, 1.0, 1e-14);
    };
    return from_top_to(0.0) + from_top_to(until_s);
}

/// Between 10^low and 10^high, each order of magnitude as likely as another.
double magnitude(config::RandomStream& stream, double low, double high) {
    return std::pow(10.0, low + (high - low) * stream.uniform());
}

struct Draw {
    Flight flight;
    double until_s;
};

Draw any_flight(std::uint32_t number) {
    config::RandomStream stream{{number, 0, 0, 0}, config::Purpose::test};
    const double plan_mps = magnitude(stream, -4.0, 2.0);
    const double rising_mps = magnitude(stream, -4.0, 2.0) * (stream.uniform() < 0.5 ? -1.0 : 1.0);
    return {flight_of(plan_mps, rising_mps), magnitude(stream, -4.0, 1.3)};
}

RC_GTEST_PROP(PathLength, IsTheIntegralOfTheSpeed, ()) {
    const auto [flight, until_s] = any_flight(*rc::gen::arbitrary<std::uint32_t>());
    const double expected_m = by_quadrature_m(flight, until_s);
    RC_ASSERT(std::abs(path_length_m(flight, until_s) - expected_m) <= 1e-10 * expected_m);
}

RC_GTEST_PROP(PathLength, IsTheSumOfItsParts, ()) {
    const auto number = *rc::gen::arbitrary<std::uint32_t>();
    const auto [flight, until_s] = any_flight(number);
    const double part_s = until_s * config::RandomStream{{number, 1, 0, 0}, config::Purpose::test}.uniform();
    const Flight rest{flight.position_m(part_s), flight.velocity_at(part_s)};
    const double whole_m = path_length_m(flight, until_s);
    const double parts_m = path_length_m(flight, part_s) + path_length_m(rest, until_s - part_s);
    RC_ASSERT(std::abs(whole_m - parts_m) <= 1e-11 * whole_m);
}

RC_GTEST_PROP(PathLength, IsNoShorterThanTheStraightLine, ()) {
    const auto [flight, until_s] = any_flight(*rc::gen::arbitrary<std::uint32_t>());
    const double line_m = (flight.position_m(until_s) - flight.start_m).norm();
    RC_ASSERT(path_length_m(flight, until_s) >= line_m * (1.0 - 1e-11));
}

RC_GTEST_PROP(PathLength, IsTheSameBackwards, ()) {
    const auto [flight, until_s] = any_flight(*rc::gen::arbitrary<std::uint32_t>());
    const Flight back{flight.position_m(until_s), -flight.velocity_at(until_s)};
    const double length_m = path_length_m(flight, until_s);
    RC_ASSERT(std::abs(path_length_m(back, until_s) - length_m) <= 1e-11 * length_m);
}

TEST(PathLength, CountsUpAndDownOfAVerticalFlight) {
    // 9.81 m/s^2 turn a rock at 10 m/s after 1.0194 s; up and down the same way.
    const double top_m = 50.0 / gravity_mps2;
    EXPECT_NEAR(path_length_m(flight_of(0.0, 10.0), 20.0 / gravity_mps2), 2.0 * top_m, 1e-12);
    EXPECT_NEAR(path_length_m(flight_of(0.0, 10.0), 10.0 / gravity_mps2), top_m, 1e-12);
    EXPECT_NEAR(path_length_m(flight_of(0.0, -10.0), 1.0), 10.0 + 0.5 * gravity_mps2, 1e-12);
    // Hardly sideways is nearly the same: no jump where the plan view shrinks to a point.
    for (const double plan_mps : {1e-3, 1e-6, 1e-9, 1e-100, 1e-160}) {
        EXPECT_NEAR(path_length_m(flight_of(plan_mps, 10.0), 20.0 / gravity_mps2), 2.0 * top_m,
                    10.0 * plan_mps + 1e-12)
            << plan_mps;
    }
}

TEST(PathLength, IsStraightForAMoment) {
    for (const double until_s : {1e-3, 1e-6, 1e-9, 1e-12}) {
        EXPECT_NEAR(path_length_m(flight_of(30.0, 0.0), until_s), 30.0 * until_s, 1e-6 * 30.0 * until_s);
    }
    EXPECT_EQ(path_length_m(flight_of(30.0, 5.0), 0.0), 0.0);
    EXPECT_EQ(path_length_m(flight_of(0.0, 0.0), 0.0), 0.0);
}

TEST(PathLength, OfFourImpactsBelowADropOfTenMetresIsSixteenAndAHalf) {
    // Half the speed is kept at each impact, so each hop is a quarter as high: 10 + 2 (10/4 + 10/16 + 10/64).
    double speed_mps = std::sqrt(2.0 * gravity_mps2 * 10.0);
    double way_m = path_length_m(flight_of(0.0, 0.0), speed_mps / gravity_mps2);
    for (int hop = 1; hop <= 3; ++hop) {
        speed_mps *= 0.5;
        way_m += path_length_m(flight_of(0.0, speed_mps), 2.0 * speed_mps / gravity_mps2);
    }
    EXPECT_NEAR(way_m, 16.5625, 1e-12);
}

}  // namespace
}  // namespace rockfall::path_length_test
