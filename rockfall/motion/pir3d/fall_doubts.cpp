#include "rockfall/motion/pir3d/fall_doubts.hpp"

#include <cmath>

#include "config/text/joined.hpp"

namespace rockfall::pir3d {

/// The filmed and surveyed rocks that models are held against stay below this speed.
std::vector<std::string> doubts_after(const FallFigures& falls, const Law&) {
    constexpr double confirmed_mps = 40.0;  // choice: the fastest rocks of Vaujany had about 30 m/s
    if (!(falls.largest_speed_mps > confirmed_mps)) {
        return {};
    }
    return {config::joined("pir3d: the fastest rock reaches ",
                           std::to_string(std::lround(falls.largest_speed_mps)),
                           " m/s; nothing confirms this model above 40 m/s, as none of its losses grows with "
                           "speed. Take speeds, heights and energies from another rockfall.motion")};
}

}  // namespace rockfall::pir3d
