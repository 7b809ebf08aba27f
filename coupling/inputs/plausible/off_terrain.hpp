#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "config/geometry/shape.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/systems/extent.hpp"

namespace coupling::plausible {

/// If more than this share of the trees, logs or sources lies off the terrain, the file is not of this
/// terrain or its coordinates are wrong: an error. A smaller share is left out with a warning. [choice]
inline constexpr double most_off_terrain = 0.5;

/// Why places do not lie on the terrain, as far as their coordinates show it, and what to do.
struct OffCause {
    std::string reason;  ///< "x and y look swapped"
    std::string advice;  ///< "exchange the columns x_m and y_m"
};

/// A slip of writing by which places lie elsewhere: exchanged axes, degrees, another unit or a known
/// difference between coordinate systems, with which more than half of the places would lie inside the extent
/// of the terrain; nothing where no such change explains it. Requires at least one place.
std::optional<OffCause> slip_of_coordinates(const Extent& terrain, std::span<const config::Point2> places,
                                            std::string_view swap_advice);

/// Whether things lie so near to the terrain that they were probably meant there.
bool lies_beside(const Extent& terrain, const Extent& extent);

/// Looks for exchanged axes, degrees, another unit and known differences between coordinate systems: those
/// with which more than half of the places would lie inside the extent of the terrain. `swap_advice` is what
/// to do about exchanged axes. Requires at least one place.
OffCause cause_off_terrain(const Extent& terrain, std::span<const config::Point2> places,
                           std::string_view swap_advice);

/// Things of one file and how many of them lie off the terrain.
struct OffTerrain {
    config::Place place;
    std::string_view singular;  ///< "tree"
    std::size_t all = 0;
    std::size_t off = 0;
    std::string example;                     ///< "tree '17' (x 1060, y 2500)"
    std::span<const config::Point2> places;  ///< of all of them
    std::string_view swap_advice;
    std::string cut;  ///< command that cuts the file to the terrain, "" where there is none
};

/// How many places lie outside of terrain.extent_m; 0 without it. What the user cut off needs no warning.
std::size_t outside_of_stated_extent(std::span<const config::Point2> places, const Reading& reading);

/// A problem where most of them lie off the terrain, with the likely cause; a warning where some do; a note
/// where terrain.extent_m leaves them out.
void judge_off_terrain(const OffTerrain& things, const Extent& terrain, Reading& reading);

}  // namespace coupling::plausible
