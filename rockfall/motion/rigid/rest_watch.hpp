#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <utility>

#include "config/math/elementary.hpp"
#include "rockfall/motion/rigid/body.hpp"
#include "rockfall/motion/rigid/law.hpp"
#include "rockfall/motion/rigid/motion.hpp"
#include "rockfall/slope/surface_stops.hpp"

namespace rockfall::rigid {

/// Decides when a block rests.
///
/// It does so if it lies without motion over a few steps. A block also creeps or, in a hollow, chatters:
/// short flights and impacts that lead nowhere. It rests if over two spans of time it neither moves nor turns
/// faster than rest_mps in the mean, the second time no more than the first, and is slow whenever it has met
/// the ground. One that begins to tip moves more and more. A sphere may spin on its contact for ever, as
/// nothing resists that: of spheres only the centre counts. [choice]
class RestWatch {
public:
    RestWatch(const Law& law, const solids::Solid& solid)
        : law_{law}, solid_{solid}, turning_radius_m_{solid.is_sphere() ? 0.0 : solid.bounding_radius_m} {}

    /// Whether the block rests now. To be asked after each flight and each step on the ground, in order.
    bool rests(const Body& body, double time_s, bool on_ground) {
        const double speed_mps =
            body.velocity_mps.norm() + body.spin_radps(solid_).norm() * turning_radius_m_;
        const bool lies = lies_still(speed_mps, time_s, on_ground);
        return is_still_over_spans(body, speed_mps, time_s) || lies;
    }

private:
    bool lies_still(double speed_mps, double time_s, bool on_ground) {
        constexpr double still_mps = 1e-6;
        constexpr double a_few_steps_s = 0.02;
        if (!on_ground || speed_mps > still_mps) {
            still_since_s_ = -1.0;
        } else if (still_since_s_ < 0.0) {
            still_since_s_ = time_s;
        }
        return still_since_s_ >= 0.0 && time_s - still_since_s_ >= a_few_steps_s;
    }

    bool is_still_over_spans(const Body& body, double speed_mps, double time_s) {
        fastest_mps_ = std::max(fastest_mps_, speed_mps);
        const double span_s = time_s - span_start_s_;
        if (span_s < law_.rest_s) {
            return false;
        }
        const Eigen::Quaterniond turn = attitude_.conjugate() * body.rotation.attitude;
        // Twice the sine of half the angle: up to rounding the angle where it is small.
        const double moved_mps =
            ((body.centre_m - centre_m_).norm() + 2.0 * turn.vec().norm() * turning_radius_m_) / span_s;
        constexpr double of_chatter = 10.0;
        constexpr double no_more = 1.2;
        const bool is_still = moved_mps < law_.rest_mps && fastest_mps_ < of_chatter * law_.rest_mps;
        const bool rests = is_still && was_still_ && moved_mps <= no_more * last_moved_mps_;
        was_still_ = is_still;
        last_moved_mps_ = moved_mps;
        span_start_s_ = time_s;
        centre_m_ = body.centre_m;
        attitude_ = body.rotation.attitude;
        fastest_mps_ = 0.0;
        return rests;
    }

    const Law& law_;
    const solids::Solid& solid_;
    double turning_radius_m_;
    double still_since_s_ = -1.0;
    double span_start_s_ = 0.0;
    Eigen::Vector3d centre_m_ = Eigen::Vector3d::Zero();
    Eigen::Quaterniond attitude_ = Eigen::Quaterniond::Identity();
    double fastest_mps_ = 0.0;
    double last_moved_mps_ = 0.0;
    bool was_still_ = false;
};

/// Decides where the surface catches a block by chance: with a probability at each impact and a rate along
/// its way on the ground. Of laws that stop by chance.
class ChanceStops {
public:
    ChanceStops(const Law& law, Motion motion, double diameter_m)
        : motion_{std::move(motion)}, plastic_mps_{law.plastic_mps}, surface_stops_{diameter_m} {
        constexpr std::uint32_t once_per_rock = 0xFFFFFF;
        way_left_ = -config::ln_of(1.0 - motion_.ground_draws.uniforms_of(once_per_rock)[1]);
    }

    /// One draw for each impact above the speed at which ground is plastic.
    bool catches_at_impact(double into_ground_mps, const SurfaceType& surface) {
        if (into_ground_mps <= plastic_mps_) {
            return false;
        }
        const double u = motion_.ground_draws.uniforms_of(impacts_drawn_++)[0];
        return u < surface_stops_.probability(surface);
    }

    bool catches_on_way(double way_m, const SurfaceType& surface) {
        way_left_ -= way_m * surface_stops_.rolling_rate(surface);
        return way_left_ <= 0.0;
    }

private:
    Motion motion_;
    double plastic_mps_;
    SurfaceStops surface_stops_;
    std::uint32_t impacts_drawn_ = 0;
    double way_left_;  ///< by the rate [-]
};

}  // namespace rockfall::rigid
