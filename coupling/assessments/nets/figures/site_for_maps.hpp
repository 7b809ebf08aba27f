#pragma once

#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// A frame of the whole terrain with a few hundred cells a side, in its coordinates.
config::GridFrame map_frame_of(const rockfall::Terrain& terrain);

/// A site with nothing but ground, lines and nets, as maps draw it: of stored paths no other is known.
/// `frame` in coordinates of the terrain.
Site site_for_maps(const rockfall::Terrain& terrain, config::GridFrame frame,
                   std::vector<rockfall::Target> targets, std::vector<NetRecord> nets);

}  // namespace coupling
