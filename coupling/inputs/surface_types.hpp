#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/inputs/reading.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/slope.hpp"

namespace coupling {

/// What the columns of a ground type may hold.
inline constexpr config::NumberRange restitution_range{.low = 0.0, .high = rockfall::largest_restitution};
inline constexpr config::NumberRange angle_factor_range{.low = 0.1, .high = 10.0};
inline constexpr config::NumberRange probability_range{.low = 0.0, .high = 1.0};
inline constexpr config::NumberRange rolling_stops_range{.low = 0.0, .high = 100.0};
inline constexpr config::NumberRange rolling_friction_range{.low = 0.01, .high = 2.0};
inline constexpr config::NumberRange sliding_friction_range{.low = 0.01, .high = 5.0};

/// A row of config/data/surfaces.csv with its rows of stopping.csv.
struct ShippedSurface {
    std::string name;
    rockfall::SurfaceType type;  ///< code 0
};

std::vector<ShippedSurface> shipped_surfaces();
/// The same with what sections `[ground.NAME]` of these settings change. Throws as GroundChanges does.
std::vector<ShippedSurface> shipped_surfaces(const config::Options& settings);

/// Stopping probability by rock diameter where only that of a rock of 0.95 m is known: scaled by
/// config/data/stopping_size.csv, at most 1.
rockfall::StopCurve stop_curve(double stop_probability);

/// The ground types of a scenario; empty where it names none.
///
/// A row of terrain.surface_types takes r_n, r_t, p_stop from its own columns, else from the shipped type in
/// its column `like`. Stopping comes from terrain.stopping where that has the code, else from p_stop, else
/// from the curve of the shipped type. Its soil is named in its column `soil`, else that of the
/// shipped type; where rockfall.motion asks for soils, a row without one is refused. Stopping tables that do
/// not reach over all sizes of `rocks` are doubtful.
std::optional<std::vector<rockfall::SurfaceType>> read_surface_types(const rockfall::DiameterRange& rocks,
                                                                     Reading& reading);

/// The shipped type that terrain.ground names; nothing without that setting. Throws InputError (settings)
/// with the nearest name for an unknown one.
std::optional<rockfall::SurfaceType> uniform_ground(const Scenario& scenario);

}  // namespace coupling
