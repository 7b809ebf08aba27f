#pragma once

#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/nets/figures/net_paths.hpp"
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

/// The stored paths of a finished run. Throws InputError where there are none, or of another run or version.
NetPathsReader paths_of_run(const std::filesystem::path& folder);
/// A table of nets on a terrain; what is only suspicious in it becomes a remark. Throws InputError.
std::vector<NetRecord> nets_on(const std::filesystem::path& file, const rockfall::Terrain& terrain,
                               Standing standing, std::vector<std::string>& remarks);

/// What is asked of `bannwald net try`.
struct NetTryRequest {
    std::filesystem::path run;   ///< folder of a finished run
    std::filesystem::path nets;  ///< table of nets
    std::filesystem::path out;   ///< empty: run/net_try
    bool overwrite = false;
    bool quiet = false;
};

/// Looks at other nets with the stored paths of a run and writes their tables. Throws InputError.
void try_nets(const NetTryRequest& request, std::ostream& out);
/// net_inexact.csv, and with those of a run with nets all that it writes.
TableLayout net_inexact_layout();
std::vector<TableLayout> net_try_layouts();

}  // namespace coupling
