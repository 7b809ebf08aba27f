#pragma once

#include <cstddef>
#include <vector>

#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/tally/target.hpp"

namespace coupling::plausible {

/// What a target cannot have where rocks are to be counted: lines and areas without extent are errors, rings
/// that cross themselves warnings (their area is taken by the even-odd rule), two targets of one shape a
/// note. Requires a place in the file for each target; any coordinates.
void judge_shapes_of_targets(const std::vector<rockfall::Target>& targets,
                             const std::vector<config::Place>& places, Reading& reading);

/// Which targets are slivers to be left out, rising: without length or area, at most one in ten of them. A
/// layer of a map has such among its houses; where there are more, something else is wrong. One warning says
/// which. The same places as above.
std::vector<std::size_t> slivers_of(const std::vector<rockfall::Target>& targets,
                                    const std::vector<config::Place>& places, Reading& reading);

/// Whether a closed line crosses or touches itself anywhere but at its corners.
bool crosses_itself(const std::vector<Eigen::Vector2d>& ring);

}  // namespace coupling::plausible
