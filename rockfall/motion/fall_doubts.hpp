#pragma once

#include <string>
#include <vector>

#include "rockfall/motion/models.hpp"
#include "rockfall/motion/seam/fall_figures.hpp"

namespace rockfall {

/// What the chosen model is known to get wrong in what its rocks did, in sentences for users; most models
/// have nothing to say. A model says it in `doubts_after(const FallFigures&, const Law&)` beside its law, in
/// fall_doubts.hpp of its room.
std::vector<std::string> doubts_of_falls(const MotionLaws& laws, const FallFigures& falls);

}  // namespace rockfall
