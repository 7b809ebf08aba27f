#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/inputs/grids/vrt.hpp"

namespace coupling::grids {

/// Where a tile lies in a mosaic.
struct TilePlace {
    std::string file;         ///< its name in messages
    config::GridFrame frame;  ///< of the tile
    std::size_t number = 0;   ///< of whoever lists the tiles
    config::Cell first{};     ///< of its cells, in the mosaic; may lie outside of it
};

/// How tiles make one grid.
struct MosaicPlan {
    config::GridFrame frame;
    /// In the order in which they are laid: from north to south, then from west to east, by their corners in
    /// the north-west. A cell takes the value of the first tile that knows it, so that no order of files
    /// matters.
    std::vector<TilePlace> tiles;
};

/// Part of a map, in metres.
struct MapWindow {
    double west_m = 0.0;
    double south_m = 0.0;
    double east_m = 0.0;
    double north_m = 0.0;
};

/// The cells of a frame whose centres lie in a window. Throws InputError (data) where there are fewer than
/// 3 x 3; `file` names the frame in the message.
CellWindow cells_in(const config::GridFrame& frame, const MapWindow& window, const std::string& file);

/// The frame of some cells of another.
config::GridFrame frame_of(const config::GridFrame& frame, const CellWindow& cells);

/// Some cells of a grid. Requires that they lie in it.
config::Raster<double> cut_out(const config::Raster<double>& grid, const CellWindow& cells);

/// Lays tiles side by side. Throws InputError (data) naming two files whose cells have different sizes, do
/// not lie on one lattice (to a hundredth of a cell), or that lie at the very same place. Frames with
/// projections are compared by who reads them.
MosaicPlan plan_mosaic(std::vector<TilePlace> tiles);

/// The plan for some cells alone: tiles outside of them are dropped.
MosaicPlan plan_of(MosaicPlan plan, const CellWindow& cells);

/// Cells of a mosaic that no tile reaches.
struct MosaicGaps {
    std::size_t between = 0;        ///< with tiles on two opposite sides
    std::size_t first_between = 0;  ///< the first of these cells
    std::size_t beside = 0;         ///< the others, as where tiles make no rectangle
};
MosaicGaps gaps_of(const MosaicPlan& plan);

/// Where tiles overlap and do not agree.
struct MosaicOverlap {
    std::size_t cells = 0;      ///< that several tiles know
    std::size_t different = 0;  ///< of these
    double sum_of_differences = 0.0;
    double largest = 0.0;   ///< difference
    std::size_t first = 0;  ///< cell of the largest
    std::string file;       ///< the tile that was laid on the others there
};

/// A mosaic while its tiles are laid, one after the other in the order of the plan.
class Mosaic {
public:
    /// Throws InputError (data) for more cells than a grid may have.
    Mosaic(const MosaicPlan& plan, const std::string& file);

    /// Requires a grid of the frame of tile `number` of the plan.
    void lay(std::size_t number, const config::Raster<double>& tile);

    [[nodiscard]] const MosaicOverlap& overlap() const { return overlap_; }
    [[nodiscard]] config::Raster<double> taken() && { return std::move(grid_); }

private:
    const MosaicPlan& plan_;
    config::Raster<double> grid_;
    MosaicOverlap overlap_;
};

}  // namespace coupling::grids
