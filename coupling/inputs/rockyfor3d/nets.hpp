#pragma once

#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "coupling/inputs/rockyfor3d/folder.hpp"

namespace coupling::rockyfor3d {

/// A net of the project: cells of one net_number that hang together, as a line along their middle.
struct Net {
    std::string name;  ///< "net 3"; "net 3b" for the second line of a number
    std::vector<config::Point2> line;
    double height_m = 0.0;     ///< the lowest of its cells
    double capacity_kj = 0.0;  ///< the smallest of its cells
    bool varies = false;       ///< heights or energies of its cells differ
    std::size_t off_line = 0;  ///< cells further than 1.5 cells from the line: a net as wide as an area
};

struct Nets {
    std::vector<Net> nets;
    std::size_t left_out = 0;  ///< cells in the outer ring or beside NODATA, where the terrain ends
};

/// The nets of net_number, net_energy and net_height. A line goes from one end of the cells to the other by
/// the shortest way through them, without the corners that only the grid makes (up to half a cell); a single
/// cell becomes a line of its width across the fall line.
Nets nets_of(const Folder& folder);

}  // namespace coupling::rockyfor3d
