#include "rockfall/motion/classical/fall_doubts.hpp"

#include <cmath>

#include "config/text/joined.hpp"

namespace rockfall::classical {

/// Of rocks that slid off the map this friction does not know where they would stop.
std::vector<std::string> doubts_after(const FallFigures& falls, const Law& law) {
    constexpr double many_left = 0.3;  // choice: from here on the run-out of the others says little
    if (law.friction != Friction::from_rt || falls.left_share < many_left) {
        return {};
    }
    return {
        config::joined("classical: ", std::to_string(std::lround(100.0 * falls.left_share)),
                       " % of the rocks leave the terrain; with classical.friction = from_rt they slide on "
                       "over all ground steeper than that friction, so neither run-out nor what arrives "
                       "below can be used. Take classical.friction = ground or another rockfall.motion")};
}

}  // namespace rockfall::classical
