#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace rockfall {

/// A rockfall net or barrier: a vertical wall that follows the ground along a line, from `gap_m` to
/// `height_m` above the ground below it. It catches rocks from both sides.
struct Net {
    std::vector<Eigen::Vector2d>
        line_m;               ///< corners in coordinates of the terrain, two or more, no two alike
    double height_m = 0.0;    ///< of the upper edge above the ground, vertical, > 0
    double gap_m = 0.0;       ///< of the lower edge above the ground, [0, height_m)
    double capacity_j = 0.0;  ///< kinetic energy that it takes at most, > 0
};

/// What becomes of a rock that crosses the line of a net.
enum class NetOutcome : std::uint8_t {
    held,   ///< rests at the foot of the net
    over,   ///< passes over it
    below,  ///< passes through the gap below it
    broke,  ///< breaks through it
};
inline constexpr std::size_t net_outcomes = 4;

/// Whether a net changes the motion of a rock.
constexpr bool acts(NetOutcome outcome) {
    return outcome == NetOutcome::held || outcome == NetOutcome::broke;
}

/// A rock in the vertical plane of a net.
struct NetCrossing {
    std::uint32_t net;
    double along_m;          ///< along the line of the net in plan, from its first corner
    double height_m;         ///< of the rock's centre above the ground, vertical
    double radius_m;         ///< of the rock: its upper edge is this much above its centre
    double energy_j;         ///< before the net: translation and rotation
    double translational_j;  ///< the translational part of it
    double speed_mps;        ///< before the net
    NetOutcome outcome;
};

}  // namespace rockfall
