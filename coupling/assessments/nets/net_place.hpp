#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/assessments/nets/figures/net_paths.hpp"
#include "coupling/assessments/nets/figures/net_uphill.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling {

/// Distances upslope of a line at which nets are looked at unless others are asked for [m].
std::vector<double> usual_net_distances_m();

/// A net somewhere upslope of the line that it is to protect.
struct NetPlace {
    std::uint32_t line;  ///< which of the given lines
    double distance_m;   ///< in plan, upslope of it; 0: on it
    Uphill uphill;       ///< which way that is
    rockfall::Net net;
};

/// What a place is worth on one slope.
struct PlaceFigures {
    NetFigures at_net;
    Share arrive;              ///< rocks that reach the line without any net, of all that fell
    Share kept;                ///< those of them that the net here holds
    double residual_kj = 0.0;  ///< energy on the line of those that it does not hold, per rock that fell
};

/// Follows rocks past the lines and past the net at each place alone, path by path.
class PlaceTrial {
public:
    PlaceTrial(std::span<const NetRecord> lines, std::span<const NetPlace> places,
               const rockfall::Terrain& terrain);
    void look(const StoredPath& path);
    [[nodiscard]] PlaceFigures figures(std::size_t place, rockfall::Cover cover, const PathsHead& head) const;

private:
    struct AtPlace {
        rockfall::NetIndex net;
        std::vector<NetRow> rows;
        std::array<std::uint64_t, rockfall::covers> kept{};
        std::array<double, rockfall::covers> residual_j{};
    };
    std::span<const NetPlace> places_;
    const rockfall::Terrain& terrain_;
    rockfall::NetIndex lines_;  ///< so low that all pass over
    std::vector<AtPlace> at_;
    std::vector<std::array<std::uint64_t, rockfall::covers>> arrive_;  ///< by line
};

/// What is asked of `bannwald net place`.
struct NetPlaceRequest {
    std::filesystem::path run;   ///< folder of a finished run with stored paths
    std::filesystem::path nets;  ///< lines to protect; a table of nets also says what the nets would be
    std::filesystem::path out;   ///< empty: run/net_place
    std::vector<double> distances_m;
    std::optional<double> azimuth_deg;  ///< upslope, clockwise from north; none: where rocks come from
    bool overwrite = false;
    bool quiet = false;
};

/// Finds where along the lines nets are needed and which (siting/siting.hpp). Of a table of nets it also
/// looks for the place upslope of each line at which its net leaves the least energy to the line:
/// net_places.csv, and nets.csv with the best place of each. Throws InputError.
void place_nets(const NetPlaceRequest& request, std::ostream& out);

/// All tables that it writes, but nets.csv.
std::vector<TableLayout> net_place_layouts();
/// What `bannwald net` writes beside the tables of a run with nets, for `bannwald info tables`.
const std::vector<TableLayout>& net_command_layouts();

}  // namespace coupling
