#include "config/grid/holes.hpp"

#include <cmath>
#include <cstdint>

namespace config {

std::vector<Hole> holes_of(const Raster<double>& raster) {
    const GridFrame& frame = raster.frame;
    std::vector<std::uint8_t> seen(raster.values.size(), 0);
    std::vector<Hole> holes;
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < raster.values.size(); ++start) {
        if (seen[start] != 0 || !std::isnan(raster.values[start])) {
            continue;
        }
        Hole hole{start, 0};
        bool touches_rim = false;
        seen[start] = 1;
        open.push_back(start);
        while (!open.empty()) {
            const Cell cell = frame.cell_of(open.back());
            open.pop_back();
            ++hole.cells;
            for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
                for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
                    if (!frame.contains({column, row})) {
                        touches_rim = true;
                        continue;
                    }
                    const std::size_t next = frame.index({column, row});
                    if (seen[next] == 0 && std::isnan(raster.values[next])) {
                        seen[next] = 1;
                        open.push_back(next);
                    }
                }
            }
        }
        if (!touches_rim) {
            holes.push_back(hole);
        }
    }
    return holes;
}

}  // namespace config
