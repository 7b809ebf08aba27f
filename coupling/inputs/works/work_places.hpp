#pragma once

#include <span>
#include <vector>

#include "coupling/inputs/places/records.hpp"
#include "coupling/inputs/works/work_input.hpp"
#include "rockfall/release/release.hpp"
#include "rockfall/slope/slope.hpp"
#include "rockfall/tally/target.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// Puts works onto the terrain, in whose coordinates they come back: dams and ditches become a part of it,
/// and the grounds that they name join `types`. Works wholly beyond the terrain are left out with one note.
/// Problems: works that leave the terrain, faces that meet no ground, bends in which faces cross, dams and
/// ditches that overlap, sources inside of one.
std::vector<WorkRecord> place_works(GivenWorks given, std::span<const rockfall::ReleaseSource> sources,
                                    std::vector<rockfall::SurfaceType>& types, rockfall::Terrain& terrain,
                                    Reading& reading);

/// Puts lines under the roofs of galleries. A gallery over no line is warned of, and so is one over an
/// area, which it does not cover.
void put_under_roofs(std::span<const WorkRecord> works, std::vector<rockfall::Target>& targets,
                     Reading& reading);

/// Takes trees and logs out that stand or lie where a dam or a ditch is, with a note. `origin_m` of the
/// terrain.
void clear_ground_of(std::span<const WorkRecord> works, std::vector<TreeRecord>& trees,
                     std::vector<LogRecord>& logs, const Eigen::Vector2d& origin_m, Reading& reading);

}  // namespace coupling
