#pragma once

#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "rockfall/laws/block_ground.hpp"

namespace coupling {

// Ranges of the figures that ground types have for blocks with a shape.
inline constexpr config::NumberRange block_friction_range{.low = 0.0, .high = 10.0};
inline constexpr config::NumberRange slip_kappa_range{.low = 0.0, .high = 1000.0};
inline constexpr config::NumberRange slip_beta_range{.low = 0.0, .high = 1e5};
inline constexpr config::NumberRange contact_drag_range{.low = 0.0, .high = 100.0};

/// The columns of a table of ground types that speak of blocks with a shape: rigid_ground (a class of
/// config/data/rigid_grounds.csv), friction_law, and the figures.
std::vector<std::string> block_ground_columns();

/// Takes over what a row says of blocks with a shape: first the class it names, then single figures.
void read_block_ground(const config::Table& table, std::size_t row, rockfall::BlockGround& ground,
                       config::Problems& problems);

/// The classes of config/data/rigid_grounds.csv.
const std::vector<rockfall::BlockGround>& shipped_block_grounds();

}  // namespace coupling
