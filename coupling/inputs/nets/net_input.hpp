#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/table/schema.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling {

/// What a row of a table of nets says.
struct ListedNet {
    std::string name;
    double height_m = 0.0;
    double gap_m = 0.0;
    std::optional<double> capacity_kj;
    std::string energy_class;
    BarrierCost cost;
    config::Shape line;
};

const config::Schema<ListedNet>& net_columns();

/// Nets as a table gives them.
struct GivenNets {
    std::vector<NetRecord> nets;
    std::vector<config::Place> lines;  ///< where the line of each net stands in the table
};

/// Whether nets of a table stand on the slope together.
enum class Standing : std::uint8_t {
    together,    ///< refused where two stand in one place
    each_alone,  ///< looked at one by one: may share a place
};

/// The nets of a table, in absolute coordinates, behind those of other tables. Throws InputError (data) with
/// all that is wrong.
GivenNets nets_of(const config::Table& table, Standing standing = Standing::together, GivenNets given = {});

/// What is only suspicious in a table of nets: columns that are passed over, figures that look like another
/// unit, names that differ by capitals or blanks alone.
std::vector<config::Problem> net_warnings(const config::Table& table, const std::vector<NetRecord>& nets);

/// Reads the nets of the scenario; an empty list without them.
std::optional<GivenNets> read_nets(Reading& reading);

/// The first place along a net, looked at every metre, without ground below it.
std::optional<Eigen::Vector2d> first_place_off_ground(const rockfall::Net& net,
                                                      const rockfall::Terrain& terrain);

/// Moves nets into the coordinates of the terrain. A net of which a part lies outside is a problem: nothing
/// holds its height there.
std::vector<NetRecord> on_terrain(GivenNets given, const rockfall::Terrain& terrain,
                                  config::Problems& problems);

/// The same of the nets of a scenario, of which those wholly beyond the terrain are left out with one note,
/// see plausible/beyond_terrain.hpp.
std::vector<NetRecord> on_terrain(GivenNets given, const rockfall::Terrain& terrain, Reading& reading);

}  // namespace coupling
