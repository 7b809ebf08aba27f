#pragma once

#include <cstdint>

#include "rockfall/laws/losses.hpp"

namespace config {
class Options;
class Problems;
}  // namespace config

namespace rockfall {

/// Settings of [rockfall] that more than one motion model uses.
struct SharedSettings {
    double rolling_edge_deg = 4.0;
    std::uint64_t most_impacts = 20'000;
    LossLaw losses;

    /// Tangent of the bend at an edge that a rock on the ground follows [-].
    [[nodiscard]] double edge_angle_tangent() const;
};

/// Of models whose settings are written as their law uses them.
struct NothingWritten {};

/// Tangent of an angle of less than 90 degrees, the same on every machine [-].
double tangent_of_deg(double angle_deg);

}  // namespace rockfall
