#pragma once

#include <memory>

#include "rockfall/motion/fall.hpp"
#include "rockfall/motion/rigid/body.hpp"
#include "rockfall/motion/rigid/bumps.hpp"
#include "rockfall/motion/rigid/law.hpp"
#include "rockfall/slope/slope.hpp"

namespace rockfall::rigid {

/// A block where its fall begins.
struct BlockStart {
    Body body;
    std::uint32_t triangle;
    bool on_ground;
};

/// Where and how a block begins.
///
/// Falling: its lowest point lies at the release height above the ground below its centre, or higher, so that
/// it is nowhere below ground. Sliding: it lies with its largest face on the ground, turned by chance unless
/// the attitude is given (`keeps_attitude`), with its velocity along the ground. Toppling: it stands with its
/// smallest face, an edge of it downhill, and has turned about that edge until its weight line has passed it;
/// it turns on with the spin of the law. What held the edge until then does no work.
BlockStart start_of_block(const SlopeView& slope, const Law& law, const RockStart& start,
                          const solids::Solid& solid, BlockScratch& scratch, const Bumps& bumps = {});

/// The shape of a rock: its own, or a ball of its diameter and mass.
std::shared_ptr<const solids::Solid> solid_for(const RockStart& start);

}  // namespace rockfall::rigid
