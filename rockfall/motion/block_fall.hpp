#pragma once

#include "rockfall/motion/rigid/fall.hpp"

namespace rockfall {

/// The model of the list whose rocks are blocks with a shape: that under which single blocks go on which
/// another simulation set in motion.
using BlockModel = rigid::Model;

/// Centroid, velocity, attitude and angular momentum of such a block.
using MovingBlock = rigid::Body;

/// Its fall. Beside those of any rock it takes a start with a block that is under way already.
template <class Observer>
using BlockFall = Fall<BlockModel::Motion, Observer>;

}  // namespace rockfall
