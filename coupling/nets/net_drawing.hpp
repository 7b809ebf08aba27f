#pragma once

#include <string>
#include <vector>

#include "coupling/nets/net_record.hpp"

namespace coupling::report {

/// At most so many rocks are drawn at a net.
inline constexpr std::size_t most_drawn_rocks = 1500;

/// How high a drawing reaches: to the highest rock, but no higher than 99 % of them and three times the net,
/// so that single high jumps do not squeeze all others onto the axis.
double drawn_height_m(const rockfall::Net& net, const std::vector<const NetRow*>& rows);

/// The developed view of a net with the rocks that crossed it: along the net to the right, height above the
/// ground upwards. Shapes tell what became of a rock, size and colour its energy class, so that it reads in
/// black and white too. Looked at from uphill or downhill as the line was drawn.
std::string developed_view(const NetRecord& net, const std::vector<const NetRow*>& rows,
                           const std::string& title, const std::string& caption);

/// What shapes, sizes and colours mean.
std::string developed_view_legend();

}  // namespace coupling::report
