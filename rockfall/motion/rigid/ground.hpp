#pragma once

#include "rockfall/laws/block_ground.hpp"

namespace rockfall::rigid {

using rockfall::FrictionLaw;
using Ground = rockfall::BlockGround;

}  // namespace rockfall::rigid
