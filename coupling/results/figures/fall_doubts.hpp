#pragma once

#include "config/errors/warnings.hpp"
#include "coupling/results/figures/figures.hpp"
#include "rockfall/motion/fall_doubts.hpp"

namespace coupling {

/// Of the rocks over one slope.
rockfall::FallFigures fall_figures_of(const SlopeFigures& slope);

/// Warns of results that the motion model of a run is known to get wrong (rockfall::doubts_of_falls).
void warn_of_falls(const rockfall::MotionLaws& laws, const rockfall::FallFigures& falls,
                   config::Warnings& warnings);

}  // namespace coupling
