#pragma once

#include "rockfall/laws/rock.hpp"
#include "rockfall/obstacles/nets/net.hpp"

namespace rockfall {

/// What becomes of a rock in the plane of a net.
///
/// It passes over where its centre is above the upper edge, and below where all of it fits under the lower
/// one. What else comes is met by the net: more kinetic energy than the capacity (translation and rotation)
/// breaks it, else it holds the rock [Rockyfor3D v5.2: energy above the capacity goes on; Cottaz et al. 2010:
/// the wall draped on the ground; which part of the rock counts: choice].
///
/// `underside_m`: of the rock above the ground, vertical.
NetOutcome meet_net(const Net& net, const Rock& rock, double underside_m, double energy_j);

/// Speed and spin after breaking through, divided by those before: the rock keeps the energy above the
/// capacity and its direction. Requires energy_j > net.capacity_j.
double speed_factor_behind(const Net& net, double energy_j);

}  // namespace rockfall
