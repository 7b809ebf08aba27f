#pragma once

#include <string>
#include <vector>

namespace coupling {

/// The settings of section [profile].
struct ProfileSettings {
    double start_m = 0.0;            ///< distance of the release; the upper end unless it is set
    std::vector<double> stations_m;  ///< distances at which rocks are counted, or
    std::string stations;            ///< CSV: name, distance_m
    double segment_m = 10.0;         ///< length along the slope over which jumps are put together
};

}  // namespace coupling
