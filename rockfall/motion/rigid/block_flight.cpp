#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rockfall/motion/rigid/block.hpp"
#include "rockfall/motion/rigid/slip_friction.hpp"

namespace rockfall::rigid {
namespace {

using Eigen::Vector3d;

/// No advance of time towards a contact is shorter.
constexpr double least_advance_s = 1e-6;

constexpr double located_s = 1e-12;

Eigen::Vector2d in_plan(const Vector3d& place_m) {
    return place_m.head<2>();
}

}  // namespace

Body Block::flown(double time_s) {
    return {flight_.position_m(time_s), flight_.velocity_at(time_s), turning_.at(time_s)};
}

void Block::go_on(double time_s) {
    body_ = flown(time_s);
    slip_m_ = slip_without_contact_m(slip_m_, beta_ps_, time_s);
    airborne_s_ = time_s;
}

bool Block::ball_is_clear() const {
    const Vector3d& centre_m = scratch_.posed.centre_m;
    const double radius_m = solid_.bounding_radius_m;
    return std::all_of(scratch_.patch.triangles().begin(), scratch_.patch.triangles().end(),
                       [&](const NearTriangle& triangle) { return triangle.gap_m(centre_m) > radius_m; });
}

/// Walks along the flight in pieces, each with the triangles near it.
double Block::ball_clear_until_s(double from_s, bool& leaves) {
    leaves = false;
    const double radius_m = solid_.bounding_radius_m + bumps_.highest_m();
    const double piece_m = std::max(4.0, 4.0 * radius_m);
    const double plan_mps = flight_.velocity_mps.head<2>().norm();
    constexpr double vertical_s = 60.0;
    const double piece_s = std::min(vertical_s, piece_m / std::max(plan_mps, 1e-9));
    const BallFlight ball{flight_.start_m, flight_.velocity_mps, radius_m};
    std::uint32_t under = triangle_;
    double begin_s = from_s;
    while (true) {
        const Vector3d begin_m = flight_.position_m(begin_s);
        const auto found = slope_.terrain().locate(begin_m.x(), begin_m.y(), under);
        if (!found || begin_s > law_.longest_s) {
            leaves = true;
            return begin_s;
        }
        under = *found;
        const double end_s = begin_s + piece_s;
        double first_s = std::numeric_limits<double>::infinity();
        each_triangle_near(slope_.terrain(), under, in_plan(begin_m), in_plan(flight_.position_m(end_s)),
                           radius_m, scratch_.marks, [&](std::uint32_t number, const Triangle& t) {
                               NearTriangle near;
                               for (int k = 0; k < 3; ++k) {
                                   const Vertex& v = slope_.terrain().vertices()[t.corners[k]];
                                   near.corners_m[k] = {v.x_m, v.y_m, v.z_m};
                               }
                               near.normal = (near.corners_m[1] - near.corners_m[0])
                                                 .cross(near.corners_m[2] - near.corners_m[0])
                                                 .normalized();
                               near.offset_m = near.normal.dot(near.corners_m[0]);
                               near.number = number;
                               first_s =
                                   std::min(first_s, first_possible_touch_s(near, ball, begin_s, end_s));
                           });
        if (first_s <= end_s) {
            return first_s;
        }
        begin_s = end_s;
    }
}

/// Smallest gap of contacts that close, at a time of the flight.
double Block::worst_gap_m(double time_s, double reach_m) {
    const Body body = flown(time_s);
    double worst_m = reach_m;
    if (!is_over_ground(body)) {
        return worst_m;
    }
    pose(body);
    find_touches(scratch_.patch, scratch_.posed, reach_m, scratch_.touches);
    const Velocities now = velocities_of(body);
    for (const TouchPoint& touch : scratch_.touches) {
        if (touch.gap_m < worst_m && now.at(touch.point_m - body.centre_m).dot(touch.normal) < 0.0) {
            worst_m = touch.gap_m;
        }
    }
    return worst_m;
}

/// Bisection with steps of the Illinois rule between.
double Block::locate_impact_s(double clear_s, double hit_s) {
    const double reach_m = solid_.bounding_radius_m;
    double low_m = std::max(0.0, worst_gap_m(clear_s, reach_m));
    double high_m = worst_gap_m(hit_s, reach_m);
    for (int i = 0; i < 200 && hit_s - clear_s > located_s && high_m < -located_s; ++i) {
        const double share = i % 3 == 2 ? 0.5 : std::clamp(low_m / (low_m - high_m), 0.01, 0.99);
        const double time_s = clear_s + share * (hit_s - clear_s);
        if (time_s <= clear_s || time_s >= hit_s) {
            break;
        }
        const double gap_m = worst_gap_m(time_s, reach_m);
        if (gap_m < 0.0) {
            hit_s = time_s;
            high_m = gap_m;
            low_m *= 0.5;
        } else {
            clear_s = time_s;
            low_m = gap_m;
        }
    }
    return hit_s;
}

FreeFlight Block::fly() {
    flight_ = {body_.centre_m, body_.velocity_mps};
    turning_.begin(body_.rotation);
    solver_.forget();
    scar_.left_m = 0.0;
    const double radius_m = solid_.bounding_radius_m;
    const double largest_spin = body_.rotation.momentum_nms.norm() / solid_.inertia_kgm2.minCoeff();
    bool leaves = false;
    double time_s = 0.0;
    bool look_ahead = true;
    while (true) {
        if (look_ahead) {
            time_s = ball_clear_until_s(time_s, leaves);
            if (leaves) {
                return {time_s, FlightStop::left_terrain};
            }
        }
        const Body body = flown(time_s);
        if (!is_over_ground(body)) {
            return {time_s, FlightStop::left_terrain};
        }
        pose(body);
        look_ahead = ball_is_clear();
        const FreeMotion motion{body.velocity_mps, body.spin_radps(solid_),
                                solid_.is_sphere() ? 0.0 : largest_spin};
        const double most_s = 0.4 * radius_m / (body.velocity_mps.norm() + 1e-9);
        const double advance_s = std::clamp(free_time_s(scratch_.patch, scratch_.posed, motion),
                                            least_advance_s, std::max(least_advance_s, most_s));
        const double next_s = time_s + advance_s;
        if (next_s > law_.longest_s) {
            return {time_s, FlightStop::left_terrain};
        }
        if (worst_gap_m(next_s, 0.0) < 0.0) {
            return {locate_impact_s(time_s, next_s), FlightStop::contact};
        }
        time_s = next_s;
    }
}

}  // namespace rockfall::rigid
