#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "config/geometry/shape.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"
#include "forest/treatment/area.hpp"

namespace forest {

/// Where group cuts open a forest.
struct Groups {
    double side_m = 25.0;     ///< > 0, of a square hole; usually 1-1.5 tree heights (0.02-0.1 ha)
    double area_share = 0.1;  ///< [0, 1], of the area at most; usually <= 0.1 an entry
};

/// Square holes, sides along the map, around the middles of those patches of an area where most wood stands
/// on the hole: ripest first, until the share of the area is reached; never more. Between two holes stays at
/// least the side of one. Holes lie in the area with the middles of all their patches; `candidates` are the
/// trees that count (places in trees()). The order of holes with equal wood is that of the patches.
std::vector<config::Shape> ripest_groups(const Stand& stand, const SpeciesTable& species,
                                         std::span<const std::size_t> candidates, const TreatmentArea& area,
                                         const Groups& groups);

}  // namespace forest
