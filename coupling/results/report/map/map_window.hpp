#pragma once

#include <functional>

#include "config/grid/raster.hpp"

namespace coupling::report {

/// A part of a map in whole cells, from its north-western corner.
struct MapWindow {
    int column = 0;
    int row = 0;
    int columns = 0;
    int rows = 0;
    friend bool operator==(const MapWindow&, const MapWindow&) = default;
};

/// All of a map.
MapWindow whole_of(const config::GridFrame& frame);

/// The smallest window around the cells that count, with a margin of a twentieth of its larger side, and at
/// least `least_cells` on each side where the map has them; all of the map where no cell counts.
MapWindow window_around(const config::GridFrame& frame, const std::function<bool(config::Cell)>& counts,
                        int least_cells = 20);

/// The frame of a window.
config::GridFrame part_of(const config::GridFrame& frame, const MapWindow& window);

/// The cells of a window. Requires a window inside the grid.
template <class Value>
config::Raster<Value> part_of(const config::Raster<Value>& raster, const MapWindow& window) {
    config::Raster<Value> part{part_of(raster.frame, window)};
    for (std::size_t i = 0; i < part.values.size(); ++i) {
        const config::Cell cell = part.frame.cell_of(i);
        part.values[i] = raster.at({cell.column + window.column, cell.row + window.row});
    }
    return part;
}

}  // namespace coupling::report
