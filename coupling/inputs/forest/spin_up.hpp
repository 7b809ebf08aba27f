#pragma once

#include <cstdint>
#include <vector>

#include "coupling/inputs/forest/forest_site.hpp"
#include "forest/stand/cohort.hpp"
#include "forest/stand/dead_wood.hpp"
#include "forest/stand/stand.hpp"

namespace coupling {

/// What years before the start leave beside the trees.
struct SpunUp {
    forest::SnagsAndLogs dead_wood;
    std::vector<forest::Cohort> saplings;
};

/// Lets a copy of the stand of an inventory grow for site.spin_up_years without management and rocks, and
/// takes its dead wood and saplings, as old as they are then. The trees of the start stay those of the
/// inventory.
///
/// Weather is that of the first climate's years from the first one of the run on, over and over if the
/// spin-up is longer than the run. Chance is that of no year of the run. Trees that come up meanwhile are
/// left out: an inventory lists those that it counts.
SpunUp spin_up(const ForestSite& site, const forest::Stand& inventoried, std::uint64_t seed,
               std::uint32_t replicate);

}  // namespace coupling
