#pragma once

#include <cstddef>
#include <cstdint>

#include "config/grid/raster.hpp"

namespace coupling {

struct Scenario;

/// Cells that the maps of a run may have at most [choice]: 20 km x 20 km in metres.
inline constexpr double most_map_cells = 4e8;

/// Memory of this machine; 0 where it is not known.
std::uint64_t physical_memory_bytes();

/// Refuses maps that cannot be meant, before memory for them is asked for: more cells than `most_map_cells`,
/// or more than this machine can hold the sums of. `cell_size_m` 0: the cells of the frame. Throws InputError
/// (settings) that names the cell size and the extent.
void check_map_size(const config::GridFrame& extent, double cell_size_m, const Scenario& scenario);

/// Refuses an extent in plan that no slope has: coordinates of another unit, as a rule. Throws InputError
/// (data).
void check_extent(double width_m, double height_m, const std::string& file);

}  // namespace coupling
