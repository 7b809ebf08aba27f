#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "config/units/constants.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace rockfall {

/// A free flight: position and velocity at its start. No air drag (Rammer et al. 2010; Cottaz et al. 2010).
struct Flight {
    Eigen::Vector3d start_m;
    Eigen::Vector3d velocity_mps;

    [[nodiscard]] double height_m(double time_s) const {
        return start_m.z() + time_s * (velocity_mps.z() - 0.5 * config::gravity_mps2 * time_s);
    }
    [[nodiscard]] Eigen::Vector3d position_m(double time_s) const {
        return {start_m.x() + time_s * velocity_mps.x(), start_m.y() + time_s * velocity_mps.y(),
                height_m(time_s)};
    }
    [[nodiscard]] Eigen::Vector3d velocity_at(double time_s) const {
        return {velocity_mps.x(), velocity_mps.y(), velocity_mps.z() - config::gravity_mps2 * time_s};
    }
    [[nodiscard]] double squared_speed_at(double time_s) const {
        const double rising_mps = velocity_mps.z() - config::gravity_mps2 * time_s;
        return velocity_mps.x() * velocity_mps.x() + velocity_mps.y() * velocity_mps.y() +
               rising_mps * rising_mps;
    }
};

/// The stretch of a flight over one triangle: until when, and the height of the ground there.
///
/// The path is straight in plan and a triangle is flat, so the ground under the path is a straight line in
/// time from the end of one stretch to the end of the next.
struct Stretch {
    double end_s;
    double ground_end_m;
    std::uint32_t triangle;
};

enum class FlightEnd : std::uint8_t { ground, left_terrain };

/// Where a flight ended.
struct Landing {
    double time_s;
    std::uint32_t triangle;  ///< under the end; the last one inside if the rock left the terrain
    FlightEnd end;
    Plane plane;  ///< of that triangle, where the flight ended on the ground
};

/// Flies until the rock meets the ground or the border, in closed form and without time steps.
///
/// The walk goes from triangle to triangle along the straight plan view of the path. Over a plane the height
/// of a parabola is concave in time, so a positive height at both ends of a stretch rules an impact out; only
/// the triangle at whose exit the rock would be below ground has its quadratic solved. Whether a vertex lies
/// left or right of the path is one number seen from both triangles, so nothing slips through an edge.
///
/// `stretches` receives the stretches in order, the last one ending with the flight. Requires `triangle`
/// under the start and a start not below it; a start on the ground must rise from it, or else lands at once.
Landing fly(const Terrain& terrain, const Flight& flight, std::uint32_t triangle,
            std::vector<Stretch>& stretches);

/// The ground below a flight up to a time, wherever the flight is: of a block whose centre may pass nearer to
/// the ground than the point that is followed. Ends before that time at the border.
Landing pass_over(const Terrain& terrain, const Flight& flight, double until_s, std::uint32_t triangle,
                  std::vector<Stretch>& stretches);

/// Cuts the profile below a flight at a time before its end.
void cut(std::vector<Stretch>& stretches, const Terrain& terrain, const Flight& flight, double time_s);

}  // namespace rockfall
