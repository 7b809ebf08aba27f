#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coupling {

/// A rock that was seen at a target. What was not measured is missing.
struct ObservedPassage {
    std::uint32_t target = 0;                ///< its place in the list of targets
    std::optional<double> speed_mps;         ///< at the first arrival
    std::optional<double> height_m;          ///< of the underside above the ground, vertical
    std::optional<double> energy_kj;         ///< translation and rotation
    std::optional<double> translational_kj;  ///< translation alone
    std::string group;                       ///< such as the block; "" without
};

/// An impact that was seen, speeds and angles against the face of the ground.
struct ObservedImpact {
    std::optional<int> ground;            ///< code of the ground type; none: any
    std::optional<double> speed_in_mps;   ///< before it
    std::optional<double> speed_out_mps;  ///< after it; 0 where the rock stayed
    std::optional<double> angle_in_deg;   ///< below the face
    std::optional<double> angle_out_deg;  ///< above the face
    std::string group;
};

/// What was seen of an event beside the stops.
struct ObservedEvents {
    std::vector<ObservedPassage> passages;
    std::vector<ObservedImpact> impacts;
    std::uint64_t rocks = 0;  ///< that were released; 0: unknown

    [[nodiscard]] bool empty() const { return passages.empty() && impacts.empty(); }
};

}  // namespace coupling
