#pragma once

// Synthetic profiles for tests.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "config/random/stream.hpp"
#include "config/units/angle.hpp"
#include "rockfall/slope/profile_strip.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::testing {

/// The ground type of a profile.
inline SurfaceType ground(Restitution restitution, double stop_probability = 0.0) {
    SurfaceType type;
    type.restitution = restitution;
    type.stopping = StopCurve{{{1.0, stop_probability}}};
    return type;
}

/// An even profile that falls by an angle, with corners at uneven distances.
inline std::vector<ProfilePoint> even_profile(double slope_deg, double length_m) {
    const double tangent = std::tan(config::Angle::from_degrees(slope_deg).in_radians());
    std::vector<ProfilePoint> profile;
    for (double x_m = 0.0; x_m < length_m; x_m += 7.0 + 0.3 * static_cast<double>(profile.size() % 5)) {
        profile.push_back({x_m, 2000.0 - tangent * x_m, 0});
    }
    profile.push_back({length_m, 2000.0 - tangent * length_m, 0});
    return profile;
}

/// Slopes, a road, a cliff of 1 cm in plan, a counter-slope; different for each seed. Begins below 0 and
/// falls by 30 degrees there.
inline std::vector<ProfilePoint> random_profile(std::uint64_t seed) {
    config::RandomStream shape{{seed, 0, 0, 0}, config::Purpose::test};
    std::vector<ProfilePoint> profile{{-12.5, 800.0, 0}, {20.0, 781.0, 0}};
    for (int k = 0; k < 25; ++k) {
        const double kind = shape.uniform();
        double step_m = 1.0 + 25.0 * shape.uniform();
        double drop = -0.1 + 1.2 * shape.uniform();  // per metre; some rise
        if (kind < 0.1) {
            step_m = 0.01;
            drop = 4000.0 * (shape.uniform() - 0.2);  // a cliff of up to 32 m, or a wall
        } else if (kind < 0.2) {
            drop = 0.0;
        }
        const ProfilePoint last = profile.back();
        profile.push_back({last.distance_m + step_m, last.height_m - step_m * drop,
                           static_cast<std::uint8_t>(shape.uniform() < 0.5 ? 0 : 1)});
    }
    return profile;
}

/// Straight between the corners.
inline double height_on(const std::vector<ProfilePoint>& profile, double distance_m) {
    const auto next = std::upper_bound(profile.begin() + 1, profile.end() - 1, distance_m,
                                       [](double x, const ProfilePoint& p) { return x < p.distance_m; });
    const ProfilePoint& a = *(next - 1);
    return a.height_m +
           (distance_m - a.distance_m) * (next->height_m - a.height_m) / (next->distance_m - a.distance_m);
}

}  // namespace rockfall::testing
