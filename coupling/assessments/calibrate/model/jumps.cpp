#include "coupling/assessments/calibrate/model/jumps.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace coupling::calibrate {

std::vector<TrackJump> jumps_along(std::span<const ObservedImpact> impacts) {
    std::vector<TrackJump> jumps;
    std::map<std::string, const ObservedImpact*> last_of_track;
    for (const ObservedImpact& impact : impacts) {
        if (!impact.at_m) {
            continue;
        }
        const ObservedImpact*& last = last_of_track[impact.track];
        if (last != nullptr) {
            jumps.push_back({(*impact.at_m - *last->at_m).norm(),
                             impact.group.empty() ? impact.track : impact.group, last->ground});
        }
        last = &impact;
    }
    return jumps;
}

double least_jump_m(std::span<const TrackJump> jumps, const CalibrateSettings& settings) {
    if (settings.least_jump_m > 0.0 || jumps.empty()) {
        return settings.least_jump_m;
    }
    double least_m = std::numeric_limits<double>::infinity();
    for (const TrackJump& jump : jumps) {
        least_m = std::min(least_m, jump.length_m);
    }
    return least_m;
}

std::vector<int> grounds_of(std::span<const TrackJump> jumps) {
    std::set<int> grounds;
    for (const TrackJump& jump : jumps) {
        if (!jump.ground) {
            return {};
        }
        grounds.insert(*jump.ground);
    }
    return {grounds.begin(), grounds.end()};
}

}  // namespace coupling::calibrate
