#pragma once

#include <span>
#include <vector>

#include "coupling/inputs/forest/obstacle_size.hpp"
#include "forest/stand/stand.hpp"
#include "rockfall/obstacles/log.hpp"
#include "rockfall/obstacles/stem.hpp"

namespace coupling::exchange {

/// The list that goes down each year: what rocks meet, and which tree of the forest each stem is.
struct Obstacles {
    std::vector<rockfall::Stem> stems;
    std::vector<const forest::Tree*> trees;  ///< one a stem; nullptr: not a living tree of the forest
    std::vector<rockfall::Log> logs;
};

/// Length of a log on the map: it lies along the ground of its patch.
double plan_length_m(const forest::Log& log, const forest::PatchGrid& grid);

/// Forest to rockfall: living trees from 5 cm DBH, snags and stumps, then `standing` (stems that do not
/// grow), and logs, in absolute coordinates. `fracture_energy`: by species of the forest, relative to fir.
/// Pointers refer to the trees of the stand.
Obstacles stems_and_logs_of(const forest::Stand& stand, std::span<const double> fracture_energy,
                            std::span<const rockfall::Stem> standing);

/// The living trees among them and `standing` alone.
Obstacles living_stems_of(const forest::Stand& stand, std::span<const double> fracture_energy,
                          std::span<const rockfall::Stem> standing);

}  // namespace coupling::exchange
