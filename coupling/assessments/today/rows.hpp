#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "coupling/results/tables/table_of.hpp"
#include "rockfall/tally/ensemble_tally.hpp"
#include "rockfall/tally/footprint.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {

// The tables that grow while rocks fall, row by row: nothing of them is kept in memory. Positions come in
// coordinates of the terrain and are written absolute: `origin_m` is added.

struct RockRow {
    const rockfall::RockRecord& record;
    rockfall::Cover cover;
    const Eigen::Vector2d& origin_m;
    std::uint32_t zone;
    std::optional<int> end_ground;  ///< code of the ground type there; none beyond the terrain
};
/// rocks.csv: a rock and slope.
const TableOf<RockRow>& rock_table();

struct ArrivalOfRock {
    std::uint64_t rock;
    std::string_view target_id;
    rockfall::Cover cover;
    const Eigen::Vector2d& origin_m;
    const rockfall::Arrival& arrival;  ///< that reached the target
};
/// arrivals.csv: a rock, slope and target that it reached.
const TableOf<ArrivalOfRock>& arrival_table();

/// A hit on a tree or log.
template <class Record>
struct HitRow {
    std::uint64_t rock;
    std::string_view id;  ///< of the tree or log
    const Eigen::Vector2d& origin_m;
    const Record& hit;
};
/// tree_hits.csv and log_hits.csv.
const TableOf<HitRow<rockfall::TreeHitRecord>>& tree_hit_table();
const TableOf<HitRow<rockfall::LogHitRecord>>& log_hit_table();

/// A corner of a sampled path.
struct PathRow {
    std::uint64_t rock;
    rockfall::Cover cover;
    std::size_t number;
    const Eigen::Vector2d& origin_m;
    const rockfall::PathPoint& point;
};
/// trajectories.csv.
const TableOf<PathRow>& path_table();

struct WholePath {
    std::uint64_t rock;
    rockfall::Cover cover;
    double largest_kj;
    std::string wkt;
};
/// trajectories_wkt.csv: a sampled path, as QGIS opens it ("delimited text").
const TableOf<WholePath>& wkt_table();
/// Nothing for a path of one point, which is no line.
std::optional<WholePath> whole_path(std::uint64_t rock, rockfall::Cover cover,
                                    const Eigen::Vector2d& origin_m,
                                    std::span<const rockfall::PathPoint> points);

std::vector<TableLayout> row_layouts();

}  // namespace coupling
