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

/// The protection effect at a target of a whole run. Where no rock met a tree or a log both slopes are the
/// same: it is 0, and so are both ends of its interval.
std::optional<ProtectionEffect> protection_at(const rockfall::EnsembleTally& run, std::size_t target);

/// Whether an effect is 0 for sure, as protection_at gives it.
inline bool is_none_for_sure(const ProtectionEffect& effect) {
    return effect.value == 0.0 && effect.interval.low == 0.0 && effect.interval.high == 0.0;
}

/// Warns of results that the motion model of a run is known to get wrong (rockfall::doubts_of_falls).
void warn_of_falls(const rockfall::MotionLaws& laws, const rockfall::FallFigures& falls,
                   config::Warnings& warnings);

}  // namespace coupling
