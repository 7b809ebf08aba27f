#pragma once

// Two even faces that meet in an edge across the fall line, and the six ways of a rock over them.

#include <array>
#include <cmath>
#include <string>

#include "tests/rockfall/slopes.hpp"

namespace rockfall::pir3d::testing {

namespace slopes = rockfall::testing;

inline constexpr double edge_x_m = 55.0;

/// Falls by one angle to x = 55 m and by another beyond.
inline Slope bent_slope(double first_deg, double second_deg) {
    const auto tangent = [](double degrees) {
        return std::tan(config::Angle::from_degrees(degrees).in_radians());
    };
    const config::GridFrame frame{20, 6, 0.0, 0.0, 10.0, 10.0};
    return slopes::slope_over(slopes::heights_of(frame,
                                                 [&](double x, double) {
                                                     return 200.0 -
                                                            tangent(first_deg) * std::min(x, edge_x_m) -
                                                            tangent(second_deg) * std::max(0.0, x - edge_x_m);
                                                 }),
                              {0.35, 0.85});
}

/// One of the transitions of Cottaz et al. (2010, 2.3.3, Fig. 2), on ground with a threshold of 5 degrees.
struct Transition {
    char letter;
    std::string what;
    double first_deg, second_deg;  ///< dips of the two faces
    double start_x_m, height_m;
    double speed_mps, dip_deg;
};

inline const std::array<Transition, 6>& transitions() {
    static const std::array<Transition, 6> all{{
        {'a', "impact, leaves above the threshold: flies on", 30.0, 30.0, 46.0, 4.0, 5.0, 10.0},
        {'b', "impact, leaves below the threshold: slides", 30.0, 30.0, 48.0, 0.04, 8.0, 30.0},
        {'c', "edge bends down by more: flies without loss", 20.0, 40.0, 48.0, 0.0, 8.0, 20.0},
        {'d', "edge bends down by less: slides on", 30.0, 33.0, 48.0, 0.0, 8.0, 30.0},
        {'e', "edge bends up by more: impact with loss, flies", 40.0, 15.0, 48.0, 0.0, 8.0, 40.0},
        {'f', "edge bends up by less: slides on", 30.0, 27.0, 48.0, 0.0, 8.0, 30.0},
    }};
    return all;
}

struct Way {
    Slope slope;
    RockStart start;
    FallEnd end;
    slopes::EventLog log;
};

inline Way way_of(const Transition& t) {
    Way way{bent_slope(t.first_deg, t.second_deg), {}, {}, {}};
    const double dip = config::Angle::from_degrees(t.dip_deg).in_radians();
    way.start = slopes::start_at(way.slope, t.start_x_m, 30.0, t.height_m,
                                 t.speed_mps * Eigen::Vector3d{std::cos(dip), 0.0, -std::sin(dip)}, 0.6);
    std::tie(way.end, way.log) = slopes::logged_fall(way.slope, slopes::sliding_law(), way.start);
    return way;
}

}  // namespace rockfall::pir3d::testing
