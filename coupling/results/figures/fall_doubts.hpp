#pragma once

#include <cstddef>
#include <optional>

#include "config/errors/warnings.hpp"
#include "coupling/results/figures/figures.hpp"
#include "rockfall/motion/fall_doubts.hpp"

namespace coupling {

/// Of the rocks over one slope.
rockfall::FallFigures fall_figures_of(const SlopeFigures& slope);

/// Whether none of the rocks of a slope met a tree or a log.
bool met_no_tree(const rockfall::RunTally& slope);

/// The protection effect at a target of a whole run. Where none of n rocks met a tree or a log both slopes
/// are the same and it is 0: fewer than 1 - 0.025^(1/n) of all rocks meet one (97.5 %), and at worst all of
/// these arrive at the target on one slope alone.
std::optional<ProtectionEffect> protection_at(const rockfall::EnsembleTally& run, std::size_t target);

/// Warns of results that the motion model of a run is known to get wrong (rockfall::doubts_of_falls).
void warn_of_falls(const rockfall::MotionLaws& laws, const rockfall::FallFigures& falls,
                   config::Warnings& warnings);

}  // namespace coupling
