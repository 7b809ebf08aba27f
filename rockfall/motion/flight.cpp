#include "rockfall/motion/flight.hpp"

#include <algorithm>
#include <cmath>

namespace rockfall {
namespace {

using config::gravity_mps2;

/// Plan speed below which a flight counts as vertical.
constexpr double vertical_flight_mps = 1e-6;

/// A corner seen along the path: which side, how far, how high.
struct Sighting {
    double side;   ///< (v x r).z: > 0 left of the path [m2/s]
    double along;  ///< v . r [m2/s]
    double height_m;
};

Sighting sight(const Vertex& vertex, const Flight& flight) {
    const double rx = vertex.x_m - flight.start_m.x();
    const double ry = vertex.y_m - flight.start_m.y();
    const double vx = flight.velocity_mps.x();
    const double vy = flight.velocity_mps.y();
    return {vx * ry - vy * rx, vx * rx + vy * ry, vertex.z_m};
}

/// When the parabola comes down through the plane. The start may lie below the plane where its triangle has
/// not begun yet.
double landing_time_s(const Plane& plane, const Flight& flight) {
    const double above_m = flight.start_m.z() - plane.height_m(flight.start_m.x(), flight.start_m.y());
    const double rising_mps = flight.velocity_mps.z() - plane.gradient.x() * flight.velocity_mps.x() -
                              plane.gradient.y() * flight.velocity_mps.y();
    const double root = std::sqrt(std::max(0.0, rising_mps * rising_mps + 2.0 * gravity_mps2 * above_m));
    // Two forms of one root: the sum of equal signs loses no digits.
    return rising_mps >= 0.0 ? (rising_mps + root) / gravity_mps2 : 2.0 * above_m / (root - rising_mps);
}

/// The edge over which the path leaves: right and left end, and the triangle beyond.
struct Gate {
    std::uint32_t right;
    std::uint32_t left;
    std::uint32_t beyond;
    Sighting right_end;
    Sighting left_end;
};

/// The gate out of the first triangle; false if, by rounding, the path misses it.
bool first_gate(const Terrain& terrain, const Flight& flight, std::uint32_t triangle, Gate& gate) {
    const Triangle& t = terrain.triangles()[triangle];
    Sighting seen[3];
    for (int i = 0; i < 3; ++i) {
        seen[i] = sight(terrain.vertices()[t.corners[i]], flight);
    }
    for (int i = 0; i < 3; ++i) {
        const int j = i == 2 ? 0 : i + 1;
        if (seen[i].side < 0.0 && seen[j].side >= 0.0) {
            gate = {t.corners[i], t.corners[j], t.neighbours[i], seen[i], seen[j]};
            return true;
        }
    }
    return false;
}

/// Steps over the gate: the third corner of the next triangle decides which of its other edges is next.
void step_over(const Terrain& terrain, const Flight& flight, Gate& gate) {
    const Triangle& t = terrain.triangles()[gate.beyond];
    // Counter-clockwise the shared edge runs from the left end to the right end; then comes the third corner.
    int k = 0;
    while (t.corners[k] == gate.left || t.corners[k] == gate.right) {
        ++k;
    }
    const std::uint32_t third = t.corners[k];
    const Sighting seen = sight(terrain.vertices()[third], flight);
    if (seen.side < 0.0) {
        gate.right = third;
        gate.right_end = seen;
        gate.beyond = t.neighbours[k];
    } else {
        gate.left = third;
        gate.left_end = seen;
        gate.beyond = t.neighbours[k == 0 ? 2 : k - 1];
    }
}

Landing fall_straight_down(const Terrain& terrain, const Flight& flight, std::uint32_t triangle,
                           std::vector<Stretch>& stretches) {
    const Plane plane = terrain.plane_of(triangle);
    const double time_s = std::max(0.0, landing_time_s(plane, flight));
    stretches.push_back({time_s, plane.height_m(flight.start_m.x(), flight.start_m.y()), triangle});
    return {time_s, triangle, FlightEnd::ground};
}

/// The first gate when the start lies a rounding error outside its triangle: looks from a hair further along
/// the path.
bool first_gate_nearby(const Terrain& terrain, const Flight& flight, std::uint32_t& triangle, Gate& gate) {
    const double plan_speed_mps = flight.velocity_mps.head<2>().norm();
    for (const double ahead_m : {1e-9, 1e-7, 1e-5}) {
        const double time_s = ahead_m / plan_speed_mps;
        const auto found = terrain.locate(flight.start_m.x() + time_s * flight.velocity_mps.x(),
                                          flight.start_m.y() + time_s * flight.velocity_mps.y(), triangle);
        if (found && first_gate(terrain, flight, *found, gate)) {
            triangle = *found;
            return true;
        }
    }
    return false;
}

}  // namespace

Landing fly(const Terrain& terrain, const Flight& flight, std::uint32_t triangle,
            std::vector<Stretch>& stretches) {
    stretches.clear();
    const double squared_plan_speed = flight.velocity_mps.head<2>().squaredNorm();
    if (squared_plan_speed < vertical_flight_mps * vertical_flight_mps) {
        return fall_straight_down(terrain, flight, triangle, stretches);
    }
    Gate gate;
    if (!first_gate(terrain, flight, triangle, gate) && !first_gate_nearby(terrain, flight, triangle, gate)) {
        return {0.0, triangle, FlightEnd::left_terrain};
    }
    const double per_squared_speed = 1.0 / squared_plan_speed;
    double entry_s = 0.0;
    while (true) {
        const Sighting& left = gate.left_end;
        const Sighting& right = gate.right_end;
        const double share = left.side / (left.side - right.side);
        const double exit_s =
            std::max(entry_s, (left.along + share * (right.along - left.along)) * per_squared_speed);
        const double ground_m = left.height_m + share * (right.height_m - left.height_m);
        if (flight.height_m(exit_s) < ground_m) {
            const Plane plane = terrain.plane_of(triangle);
            const double landing_s = landing_time_s(plane, flight);
            // A root beyond the exit: only rounding put the rock below ground there, as when it has just
            // jumped off this edge.
            if (landing_s <= exit_s) {
                const double time_s = std::max(landing_s, entry_s);
                const Eigen::Vector3d end = flight.position_m(time_s);
                stretches.push_back({time_s, plane.height_m(end.x(), end.y()), triangle});
                return {time_s, triangle, FlightEnd::ground};
            }
        }
        stretches.push_back({exit_s, ground_m, triangle});
        if (gate.beyond == no_triangle) {
            return {exit_s, triangle, FlightEnd::left_terrain};
        }
        triangle = gate.beyond;
        step_over(terrain, flight, gate);
        entry_s = exit_s;
    }
}

}  // namespace rockfall
