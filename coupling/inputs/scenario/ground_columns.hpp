#pragma once

#include "config/table/table.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

/// What the columns of a ground type may hold.
inline constexpr config::NumberRange restitution_range{.low = 0.0, .high = rockfall::largest_restitution};
inline constexpr config::NumberRange angle_factor_range{.low = 0.1, .high = 10.0};
inline constexpr config::NumberRange probability_range{.low = 0.0, .high = 1.0};
inline constexpr config::NumberRange rolling_stops_range{.low = 0.0, .high = 100.0};
inline constexpr config::NumberRange rolling_friction_range{.low = 0.01, .high = 2.0};
inline constexpr config::NumberRange sliding_friction_range{.low = 0.01, .high = 5.0};

/// Stopping probability by rock diameter where only that of a rock of 0.95 m is known: scaled by
/// config/data/stopping_size.csv, at most 1.
rockfall::StopCurve stop_curve(double stop_probability);

}  // namespace coupling
