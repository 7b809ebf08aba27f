#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/inputs/reading.hpp"
#include "coupling/nets/net_record.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// The nets of a table, in absolute coordinates. Throws InputError (data) with all that is wrong.
///
/// Columns name, height_m, either capacity_kj or class, wkt (LINESTRING); perhaps gap_m (0).
std::vector<NetRecord> nets_of(const config::Table& table);

/// Reads the nets of the scenario; an empty list without them.
std::optional<std::vector<NetRecord>> read_nets(Reading& reading);

/// The first place along a net, looked at every metre, without ground below it.
std::optional<Eigen::Vector2d> first_place_off_ground(const rockfall::Net& net,
                                                      const rockfall::Terrain& terrain);

/// Moves nets into the coordinates of the terrain. A net of which a part lies outside is a problem at the
/// table `file`: nothing holds its height there.
std::vector<NetRecord> on_terrain(std::vector<NetRecord> nets, const rockfall::Terrain& terrain,
                                  const std::string& file, config::Problems& problems);

}  // namespace coupling
