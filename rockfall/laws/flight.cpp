#include "rockfall/laws/flight.hpp"

#include <algorithm>
#include <array>
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

/// Looks at the terrain along the plan view of a flight.
struct View {
    const Vertex* vertices;
    const Triangle* triangles;
    double x_m, y_m;
    double vx_mps, vy_mps;

    View(const Terrain& terrain, const Flight& flight)
        : vertices{terrain.vertices().data()},
          triangles{terrain.triangles().data()},
          x_m{flight.start_m.x()},
          y_m{flight.start_m.y()},
          vx_mps{flight.velocity_mps.x()},
          vy_mps{flight.velocity_mps.y()} {}

    [[nodiscard]] Sighting sight(std::uint32_t vertex) const {
        const Vertex& v = vertices[vertex];
        const double rx = v.x_m - x_m;
        const double ry = v.y_m - y_m;
        return {vx_mps * ry - vy_mps * rx, vx_mps * rx + vy_mps * ry, v.z_m};
    }
};

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
inline bool first_gate(const View& view, std::uint32_t triangle, Gate& gate) {
    const Triangle& t = view.triangles[triangle];
    const auto [a, b, c] = t.corners;
    const Sighting seen_a = view.sight(a);
    const Sighting seen_b = view.sight(b);
    const Sighting seen_c = view.sight(c);
    if (seen_a.side < 0.0 && seen_b.side >= 0.0) {
        gate = {a, b, t.neighbours[0], seen_a, seen_b};
    } else if (seen_b.side < 0.0 && seen_c.side >= 0.0) {
        gate = {b, c, t.neighbours[1], seen_b, seen_c};
    } else if (seen_c.side < 0.0 && seen_a.side >= 0.0) {
        gate = {c, a, t.neighbours[2], seen_c, seen_a};
    } else {
        return false;
    }
    return true;
}

/// Steps over the gate: the third corner of the next triangle decides which of its other edges is next.
inline void step_over(const View& view, Gate& gate) {
    const Triangle& t = view.triangles[gate.beyond];
    const auto [a, b, c] = t.corners;
    // Two of the corners are the ends of the gate and cancel out, whichever they are.
    const std::uint32_t third = a ^ b ^ c ^ gate.left ^ gate.right;
    const Sighting seen = view.sight(third);
    // Counter-clockwise the shared edge runs from the left end to the right end; then comes the third corner.
    const std::size_t k = third == c ? 2 : third == b ? 1 : 0;
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
    return {time_s, triangle, FlightEnd::ground, plane};
}

/// The triangle beyond the edge that the path comes nearest to with both ends.
std::uint32_t across_nearest_edge(const View& view, std::uint32_t triangle) {
    const Triangle& t = view.triangles[triangle];
    const std::array<double, 3> off{std::abs(view.sight(t.corners[0]).side),
                                    std::abs(view.sight(t.corners[1]).side),
                                    std::abs(view.sight(t.corners[2]).side)};
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::max(off[i], off[(i + 1) % 3]) < std::max(off[nearest], off[(nearest + 1) % 3])) {
            nearest = i;
        }
    }
    return t.neighbours[nearest];
}

/// The first gate when the start lies a rounding error outside its triangle: looks from a hair further along
/// the path.
bool first_gate_nearby(const Terrain& terrain, const Flight& flight, std::uint32_t& triangle, Gate& gate) {
    const double plan_speed_mps = flight.velocity_mps.head<2>().norm();
    for (const double ahead_m : {1e-9, 1e-7, 1e-5}) {
        const double time_s = ahead_m / plan_speed_mps;
        const auto found = terrain.locate(flight.start_m.x() + time_s * flight.velocity_mps.x(),
                                          flight.start_m.y() + time_s * flight.velocity_mps.y(), triangle);
        if (!found) {
            continue;
        }
        // A path along an edge may have all of the triangle on its left: the gate is that of the other side.
        const View view{terrain, flight};
        for (const std::uint32_t candidate : {*found, across_nearest_edge(view, *found)}) {
            if (candidate != no_triangle && first_gate(view, candidate, gate)) {
                triangle = candidate;
                return true;
            }
        }
    }
    return false;
}

}  // namespace

Landing fly(const Terrain& terrain, const Flight& flight, std::uint32_t triangle,
            std::vector<Stretch>& stretches) {
    stretches.clear();
    const View view{terrain, flight};
    const double squared_plan_speed = view.vx_mps * view.vx_mps + view.vy_mps * view.vy_mps;
    if (squared_plan_speed < vertical_flight_mps * vertical_flight_mps) {
        return fall_straight_down(terrain, flight, triangle, stretches);
    }
    Gate gate;
    if (!first_gate(view, triangle, gate)) {
        Gate nearby;
        if (!first_gate_nearby(terrain, flight, triangle, nearby)) {
            return {0.0, triangle, FlightEnd::left_terrain, {}};
        }
        gate = nearby;
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
                return {time_s, triangle, FlightEnd::ground, plane};
            }
        }
        stretches.push_back({exit_s, ground_m, triangle});
        if (gate.beyond == no_triangle) {
            return {exit_s, triangle, FlightEnd::left_terrain, {}};
        }
        triangle = gate.beyond;
        step_over(view, gate);
        entry_s = exit_s;
    }
}

Landing pass_over(const Terrain& terrain, const Flight& flight, double until_s, std::uint32_t triangle,
                  std::vector<Stretch>& stretches) {
    stretches.clear();
    const View view{terrain, flight};
    const double squared_plan_speed = view.vx_mps * view.vx_mps + view.vy_mps * view.vy_mps;
    const auto end_here = [&](double time_s) {
        const Eigen::Vector3d end = flight.position_m(time_s);
        stretches.push_back({time_s, terrain.plane_of(triangle).height_m(end.x(), end.y()), triangle});
        return Landing{time_s, triangle, FlightEnd::ground, {}};
    };
    if (squared_plan_speed < vertical_flight_mps * vertical_flight_mps) {
        return end_here(until_s);
    }
    Gate gate;
    if (!first_gate(view, triangle, gate)) {
        Gate nearby;
        if (!first_gate_nearby(terrain, flight, triangle, nearby)) {
            return end_here(until_s);
        }
        gate = nearby;
    }
    double entry_s = 0.0;
    while (true) {
        const double share = gate.left_end.side / (gate.left_end.side - gate.right_end.side);
        const double along = gate.left_end.along + share * (gate.right_end.along - gate.left_end.along);
        const double exit_s = std::max(entry_s, along / squared_plan_speed);
        if (exit_s >= until_s) {
            return end_here(until_s);
        }
        const double ground_m =
            gate.left_end.height_m + share * (gate.right_end.height_m - gate.left_end.height_m);
        stretches.push_back({exit_s, ground_m, triangle});
        if (gate.beyond == no_triangle) {
            return {exit_s, triangle, FlightEnd::left_terrain, {}};
        }
        triangle = gate.beyond;
        step_over(view, gate);
        entry_s = exit_s;
    }
}

void cut(std::vector<Stretch>& stretches, const Terrain& terrain, const Flight& flight, double time_s) {
    std::size_t k = 0;
    while (k + 1 < stretches.size() && stretches[k].end_s < time_s) {
        ++k;
    }
    const Eigen::Vector3d end_m = flight.position_m(time_s);
    const Plane plane = terrain.plane_of(stretches[k].triangle);
    stretches.resize(k + 1);
    stretches[k] = {time_s, plane.height_m(end_m.x(), end_m.y()), stretches[k].triangle};
}

}  // namespace rockfall
