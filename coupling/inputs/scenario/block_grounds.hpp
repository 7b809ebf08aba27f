#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "rockfall/laws/block_ground.hpp"

namespace coupling {

/// A figure that ground types have for blocks with a shape.
struct BlockFigure {
    const char* name;
    double rockfall::BlockGround::*value;
    config::NumberRange range;
    const char* meaning;
};
std::span<const BlockFigure> block_figures();

/// The words of the column friction_law, in the order of rockfall::FrictionLaw.
std::vector<std::string> friction_laws();

/// The shipped class of a name. Adds a problem at `place` and returns null where there is none.
const rockfall::BlockGround* block_class(const std::string& name, const config::Place& place,
                                         config::Problems& problems);

/// The classes of config/data/rigid_grounds.csv.
const std::vector<rockfall::BlockGround>& shipped_block_grounds();

}  // namespace coupling
