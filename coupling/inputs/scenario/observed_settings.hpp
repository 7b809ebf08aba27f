#pragma once

#include <cstdint>
#include <string>

namespace coupling {

/// The settings of section [observed]: an event in the field, each file empty where nothing is known.
struct ObservedSettings {
    std::string stops;        ///< where rocks came to rest
    std::string passages;     ///< rocks seen at targets: speed, height, energy
    std::string impacts;      ///< single impacts on the ground: speeds and angles, or places along tracks
    std::string scars;        ///< wounds that rocks left on stems
    std::string trees;        ///< stems that were searched, each with the number of its wounds
    std::string outline;      ///< around the blocks that came to rest
    std::uint64_t rocks = 0;  ///< rocks that were released; 0: unknown
};

}  // namespace coupling
