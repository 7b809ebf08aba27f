#pragma once

namespace coupling::consequences {

/// Vehicles in the way of a block that crosses a road, on average [-]; below 1 nearly the probability that
/// one is hit.
///
///     vehicles a day x (length of a vehicle + diameter of the block) / (24 h x 1000 m/km x speed)
///
/// A vehicle is hit if any part of it is within the width of the block while the block crosses: each covers
/// the place for (length + diameter) / speed. Vehicles come evenly over the day, rocks at any time, and a
/// block crosses at once. One that flies over the road counts as a hit; a vehicle that runs into a block that
/// lies there does not.
///
/// Requires a speed above 0, all else not below 0.
double vehicles_in_the_way(double vehicles_per_day, double vehicle_length_m, double block_diameter_m,
                           double speed_kmph);

/// Share of the day that a person is there [0, 1].
double share_of_day(double hours_per_day);

}  // namespace coupling::consequences
