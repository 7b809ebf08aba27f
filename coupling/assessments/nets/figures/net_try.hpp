#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/assessments/nets/figures/run_terrain.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// A rock at a net.
struct NetOfRock {
    std::uint64_t rock = 0;
    rockfall::Cover cover = rockfall::Cover::bare;
    std::uint32_t net = 0;
};

/// What a stored path says of a set of nets.
struct TriedNets {
    std::vector<NetRow> rows;       ///< as a run with these nets would list them, but for rocks behind a net
                                    ///< that they broke: there nothing is listed
    std::vector<NetOfRock> broken;  ///< what these do behind the net is not known; one a rock and slope
    /// Nets on the path of such a rock behind the one that it breaks: whether it reaches them is not known.
    std::vector<NetOfRock> unknown;
    /// By row: the piece of the path and the time in it.
    std::vector<std::pair<std::size_t, double>> when;
};

/// Follows a stored path past nets until one holds the rock.
void try_nets(const rockfall::NetIndex& nets, const rockfall::Terrain& terrain, const StoredPath& path,
              TriedNets& tried);

/// The figures of nets that all paths were followed past, slope by slope. `rocks`: that fell on each.
std::vector<NetFigures> figures_of_tried(std::span<const NetRecord> nets, const TriedNets& tried,
                                         const std::array<std::uint64_t, rockfall::covers>& rocks,
                                         const PathsHead& head);

/// The stored paths of a finished run. Throws InputError where there are none, or of another run or version.
NetPathsReader paths_of_run(const std::filesystem::path& folder);
/// A table of nets on the terrain of a run; what is only suspicious in it becomes a remark. Throws
/// InputError.
std::vector<NetRecord> nets_on(const std::filesystem::path& file, const RunTerrain& run, Standing standing,
                               std::vector<std::string>& remarks);

}  // namespace coupling
