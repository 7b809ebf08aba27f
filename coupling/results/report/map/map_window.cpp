#include "coupling/results/report/map/map_window.hpp"

#include <algorithm>
#include <utility>

namespace coupling::report {
namespace {

/// Cells [first, last] along one side, widened and kept inside the map.
std::pair<int, int> widened(int first, int last, int margin, int least, int cells) {
    first -= margin;
    last += margin;
    const int missing = std::max(0, least - (last - first + 1));
    first -= missing / 2;
    last += missing - missing / 2;
    first = std::max(0, std::min(first, cells - least));
    last = std::min(cells - 1, std::max(last, first + least - 1));
    return {first, last};
}

}  // namespace

MapWindow whole_of(const config::GridFrame& frame) {
    return {0, 0, frame.columns, frame.rows};
}

MapWindow window_around(const config::GridFrame& frame, const std::function<bool(config::Cell)>& counts,
                        int least_cells) {
    int west = frame.columns;
    int east = -1;
    int north = frame.rows;
    int south = -1;
    for (int row = 0; row < frame.rows; ++row) {
        for (int column = 0; column < frame.columns; ++column) {
            if (counts({column, row})) {
                west = std::min(west, column);
                east = std::max(east, column);
                north = std::min(north, row);
                south = std::max(south, row);
            }
        }
    }
    if (east < 0) {
        return whole_of(frame);
    }
    const int margin = std::max(2, std::max(east - west, south - north) / 20);
    const auto [first, last] =
        widened(west, east, margin, std::min(least_cells, frame.columns), frame.columns);
    const auto [top, bottom] = widened(north, south, margin, std::min(least_cells, frame.rows), frame.rows);
    return {first, top, last - first + 1, bottom - top + 1};
}

config::GridFrame part_of(const config::GridFrame& frame, const MapWindow& window) {
    config::GridFrame part = frame;
    part.columns = window.columns;
    part.rows = window.rows;
    part.x_west_m = frame.x_west_m + window.column * frame.cell_width_m;
    part.y_south_m = frame.y_north_m() - (window.row + window.rows) * frame.cell_height_m;
    return part;
}

}  // namespace coupling::report
