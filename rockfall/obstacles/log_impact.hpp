#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "rockfall/laws/rock.hpp"
#include "rockfall/obstacles/log_index.hpp"

namespace rockfall {

/// How a rock gets on after it met a log.
enum class LogOutcome : std::uint8_t {
    climbed,  ///< went over it
    broke,    ///< broke it
    turned,   ///< was turned along it
    stopped,  ///< rests upslope of it
};

/// What happens at a log beside its strength.
struct LogImpactLaw {
    double loose_share = 0.5;    ///< energy that a log takes which nothing holds, by that of a held one [-]
    double climb_share = 0.2;    ///< share of a log's energy that a rock spends at most when it climbs it [-]
    double friction = 0.5;       ///< between rock and log: slows a rock that is turned along it [-]
    double stop_share = 0.02;    ///< as TreeImpactLaw [-]
    double energy_factor = 1.0;  ///< on what every log takes [-]
};

/// What a hit does to rock and log.
struct LogImpact {
    LogOutcome outcome;
    double loss_j;                 ///< energy that the rock loses
    Eigen::Vector3d velocity_mps;  ///< after the hit
    double spin_factor;            ///< spin after the hit divided by that before [-]
};

/// The rock stays at the log.
inline LogImpact rest_at(double energy_j) {
    return {LogOutcome::stopped, energy_j, Eigen::Vector3d::Zero(), 0.0};
}

/// The hit of a rock of kinetic energy `energy_j` (translation and rotation) on a log.
///
/// Three shares of the energy count: that of the motion across the log, that of the motion straight into it,
/// and, for the lift, that of gravity across it. A log whose top lies above the rock's centre takes the
/// motion across it: more than its strength breaks it, less and the rock is blocked. A lower log the rock
/// climbs if its motion across the log suffices to lift the centre over it and for `climb_share` of the log's
/// strength, of which it spends no more than its motion into the log brings. Where that motion exceeds the
/// strength the log breaks. A blocked rock keeps what plastic contact with Coulomb
/// friction leaves of its motion along the log, which is nothing if it comes steeper than 1/friction
/// across it.
///
/// At the end of a log the direction around the end takes the place of its axis.
///
/// Model of section "logs" of the room's README; no published law. There is no chance in it.
LogImpact meet_log(double energy_j, const Eigen::Vector3d& velocity_mps, const Rock& rock, const LogHit& hit,
                   const LogPiece& piece, const LogImpactLaw& law);

}  // namespace rockfall
