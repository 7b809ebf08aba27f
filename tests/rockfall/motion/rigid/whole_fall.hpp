#pragma once

#include <algorithm>

#include "rockfall/motion/rigid/block.hpp"

namespace rockfall::rigid::testing {

/// How a block that was followed to its end got there.
struct WholeFall {
    Body end;
    bool rests = false;  ///< else it left the terrain, or its time ran out
    double time_s = 0.0;
    double residual_j = 0.0;
    double dissipated_j = 0.0;
    std::uint32_t flights = 0;
    std::uint32_t steps = 0;
    std::uint64_t percussions = 0;
    std::uint32_t unsolved = 0;
    std::uint32_t triangle = no_triangle;
};

/// The event loop of a block without obstacles: flights, impacts, steps on the ground, rest.
inline WholeFall follow(const Slope& slope, const Law& law, const solids::Solid& solid, const Body& start,
                        std::uint32_t triangle, BlockScratch& scratch) {
    Block block{slope, law, solid, start, triangle, scratch};
    WholeFall fall;
    bool on_ground = false, inside = true;
    int airborne_steps = 0;
    double slow_since_s = -1.0, slow_mps = 0.0;
    while (inside && !fall.rests && fall.time_s < law.longest_s) {
        if (!on_ground) {
            const FreeFlight flight = block.fly();
            block.go_on(flight.duration_s);
            fall.time_s += flight.duration_s;
            ++fall.flights;
            inside = flight.end == FlightStop::contact;
            on_ground = inside && block.strike().lasts;
            airborne_steps = 0;
            continue;
        }
        const Touchdown touchdown = block.step(law.step_s, inside);
        fall.time_s += law.step_s;
        ++fall.steps;
        airborne_steps = touchdown.touched ? 0 : airborne_steps + 1;
        if (touchdown.touched ? !touchdown.lasts : airborne_steps >= 2) {
            block.clear_overlap();
            on_ground = false;
            continue;
        }
        const double speed_mps = block.body().velocity_mps.norm() +
                                 block.body().spin_radps(solid).norm() * solid.bounding_radius_m;
        if (speed_mps > law.rest_mps) {
            slow_since_s = -1.0;
        } else if (slow_since_s < 0.0) {
            slow_since_s = fall.time_s;
            slow_mps = speed_mps;
        } else if (fall.time_s - slow_since_s >= law.rest_s) {
            fall.rests = speed_mps <= std::max(slow_mps, 0.25 * law.rest_mps);
            slow_since_s = fall.time_s;
            slow_mps = speed_mps;
        }
    }
    if (fall.rests) {
        block.rest_on_ground();
    }
    fall.end = block.body();
    fall.residual_j = block.residual_j();
    fall.dissipated_j = block.ledger().dissipated_j();
    fall.percussions = block.percussions();
    fall.unsolved = block.unsolved();
    fall.triangle = block.triangle();
    return fall;
}

}  // namespace rockfall::rigid::testing
