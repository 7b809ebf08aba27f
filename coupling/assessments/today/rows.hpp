#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string_view>

#include "rockfall/tally/ensemble_tally.hpp"
#include "rockfall/tally/footprint.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling {

// The tables that grow while rocks fall, row by row: nothing of them is kept in memory. Positions come in
// coordinates of the terrain and are written absolute: `origin_m` is added.

/// tables/rocks.csv: one row a rock and slope. `end_ground`: code of the ground type there; none beyond the
/// terrain.
void write_rock_header(std::ostream& out);
void write_rock(std::ostream& out, const rockfall::RockRecord& record, rockfall::Cover cover,
                const Eigen::Vector2d& origin_m, std::uint32_t zone, std::optional<int> end_ground);

/// tables/arrivals.csv: one row a rock, slope and target that it reached.
void write_arrival_header(std::ostream& out);
/// Requires an arrival that reached the target.
void write_arrival(std::ostream& out, std::uint64_t rock, std::string_view target_id, rockfall::Cover cover,
                   const Eigen::Vector2d& origin_m, const rockfall::Arrival& arrival);

/// tables/tree_hits.csv: one row a hit.
void write_tree_hit_header(std::ostream& out);
void write_tree_hit(std::ostream& out, std::uint64_t rock, std::string_view tree_id,
                    const Eigen::Vector2d& origin_m, const rockfall::TreeHitRecord& hit);

/// tables/log_hits.csv: one row a hit on a lying log.
void write_log_hit_header(std::ostream& out);
void write_log_hit(std::ostream& out, std::uint64_t rock, std::string_view log_id,
                   const Eigen::Vector2d& origin_m, const rockfall::LogHitRecord& hit);

/// tables/trajectories.csv: one row a corner of a sampled path.
void write_path_header(std::ostream& out);
void write_path(std::ostream& out, std::uint64_t rock, rockfall::Cover cover, const Eigen::Vector2d& origin_m,
                std::span<const rockfall::PathPoint> points);

/// tables/trajectories_wkt.csv: one row a sampled path, as QGIS opens it ("delimited text").
void write_path_wkt_header(std::ostream& out);
void write_path_wkt(std::ostream& out, std::uint64_t rock, rockfall::Cover cover,
                    const Eigen::Vector2d& origin_m, std::span<const rockfall::PathPoint> points);

}  // namespace coupling
