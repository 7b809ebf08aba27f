#pragma once

#include <string>
#include <vector>

#include "coupling/inputs/nets/net_record.hpp"

namespace coupling::report {

/// At most so many rocks are drawn at a net on the slope with more of them.
inline constexpr std::size_t most_drawn_rocks = 1500;

/// How many of the rocks at a net are drawn on a slope: the same share on both, so that their drawings can be
/// compared. `most_rocks`: those on the slope with more of them, of which most_drawn_rocks are drawn. Rounded
/// to the nearest.
std::size_t drawn_rocks(std::size_t rocks, std::size_t most_rocks);

/// So many of the rows, evenly spaced in the order of rocks. Requires no more than there are.
std::vector<const NetRow*> evenly_spaced(const std::vector<const NetRow*>& rows, std::size_t wanted);

/// How high a drawing reaches: to the highest rock, but no higher than 99 % of them and three times the net,
/// so that single high jumps do not squeeze all others onto the axis.
double drawn_height_m(const rockfall::Net& net, const std::vector<const NetRow*>& rows);

struct DevelopedView {
    std::string drawing;    ///< SVG
    std::size_t above = 0;  ///< rocks higher than the drawing, at its upper edge
};

/// The developed view of a net with some of the rocks that crossed it, up to a height: along the net to the
/// right, height above the ground upwards. Shapes show what became of a rock, size and colour its energy
/// class, so that it reads in black and white too. Looked at from uphill or downhill as the line was drawn.
DevelopedView developed_view(const NetRecord& net, const std::vector<const NetRow*>& drawn, double highest_m,
                             const std::string& label);

/// What shapes, sizes and colours mean: items of a list.
std::string developed_view_legend();

}  // namespace coupling::report
