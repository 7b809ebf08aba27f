#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/assessments/nets/figures/run_terrain.hpp"
#include "coupling/inputs/nets/net_record.hpp"

namespace coupling::siting {

/// A line that is to be protected, such as a road, in coordinates of the terrain.
struct ProtectedLine {
    std::string name;
    std::vector<Eigen::Vector2d> line_m;  ///< two corners or more, no two alike in a row
};

/// What a file of lines holds: lines to protect, and what nets upslope of them would be where the file says.
struct GivenLines {
    std::vector<ProtectedLine> lines;
    std::vector<NetRecord> nets;  ///< empty where the file has no columns of nets
};

/// Lines of a table without columns of nets, in absolute coordinates: name from `name`, else `target_id`,
/// else the number of the row. Parts of a shape become lines of their own. Areas are left out with a remark.
/// Throws InputError (data) with all that is wrong.
std::vector<ProtectedLine> lines_of(const config::Table& table, std::vector<std::string>& remarks);

/// Reads a table or layer of lines. With a column `height_m` or `capacity_kj` it is a table of nets
/// (net_input.hpp); without, it is taken as it is. Parts of lines off the terrain become remarks. Lines
/// wholly off it are left out with one remark, as a layer may be that of a commune; slips of coordinates, and
/// a file of which nothing lies on the terrain, throw InputError (data): plausible/beyond_terrain.hpp.
GivenLines read_lines(const std::filesystem::path& file, const RunTerrain& run,
                      std::vector<std::string>& remarks);

/// Length in plan.
double length_m(const std::vector<Eigen::Vector2d>& line_m);

/// The piece of a line between two distances from its first corner, straight on beyond its ends where they
/// lie there. Requires a line of two corners and from_m < to_m.
std::vector<Eigen::Vector2d> piece_of(const std::vector<Eigen::Vector2d>& line_m, double from_m, double to_m);

}  // namespace coupling::siting
