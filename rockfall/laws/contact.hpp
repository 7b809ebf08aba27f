#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace rockfall {

/// How a rock goes on after it touched the ground.
enum class Onward : std::uint8_t { flies, rolls, rests, caught };

/// Motion after a ground contact.
struct Contact {
    Onward onward;
    Eigen::Vector3d velocity_mps;
    double spin_radps;
};

/// What a rock on the ground does where one face ends and the next begins.
enum class EdgeWay : std::uint8_t {
    goes_on,    ///< stays on the ground: its motion turns into the next face
    takes_off,  ///< the ground falls away: flies without loss
    runs_into,  ///< the ground rises: an impact on the next face
};

}  // namespace rockfall
