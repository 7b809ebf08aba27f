#pragma once

namespace rockfall {

/// What the rocks of a run did, for what a motion model is known to get wrong.
struct FallFigures {
    double largest_speed_mps = 0.0;
    double left_share = 0.0;  ///< of the rocks: they left the terrain [-]
};

}  // namespace rockfall
