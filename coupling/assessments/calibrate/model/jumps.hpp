#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/inputs/observed/observed_events.hpp"
#include "coupling/inputs/scenario/calibrate_settings.hpp"

namespace coupling::calibrate {

/// A jump between two impacts that follow each other on a track.
struct TrackJump {
    double length_m = 0.0;      ///< in plan
    std::string group;          ///< of the impacts; without one the track
    std::optional<int> ground;  ///< on which it begins
};

/// Of all tracks, in the order of the rows of impacts.
std::vector<TrackJump> jumps_along(std::span<const ObservedImpact> impacts);

/// Jumps below this length do not count: what was set, else the shortest one that was seen.
double least_jump_m(std::span<const TrackJump> jumps, const CalibrateSettings& settings);

/// The grounds on which jumps begin, rising; none where one of them is not known: then any.
std::vector<int> grounds_of(std::span<const TrackJump> jumps);

}  // namespace coupling::calibrate
