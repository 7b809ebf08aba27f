#pragma once

#include <cstdint>

#include "rockfall/laws/losses.hpp"

namespace rockfall::pir3d {

/// Which distribution the parameters of a contact follow around their means.
enum class Spread : std::uint8_t { uniform, normal };

/// How its width depends on speed.
enum class Uncertainty : std::uint8_t {
    off,       ///< no chance at all
    constant,  ///< that of a rock at rest
    by_speed,  ///< falls with speed (Cottaz et al. 2010, Eqs. 6-9)
};

/// The settings of the motion model of PiR3D (Cottaz et al. 2010); its grounds are in soil.hpp.
struct Law {
    Spread spread = Spread::uniform;
    Uncertainty uncertainty = Uncertainty::by_speed;
    bool turns_sideways = true;          ///< no along a profile
    double position_tolerance_m = 1e-3;  ///< error of one step of sliding
    double least_hop = 0.1;              ///< hops shorter than this times the rock's radius are sliding [-]
    std::uint32_t most_impacts = 20'000;
    LossLaw losses{};
};

}  // namespace rockfall::pir3d
