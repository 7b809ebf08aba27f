#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "config/grid/raster.hpp"
#include "rockfall/terrain/terrain.hpp"

namespace coupling::plausible {

/// Slopes of a terrain in square cells around the middle of its extent, so that a terrain that is turned by a
/// right angle or mirrored has the same ones. Coordinates of the terrain.
class SlopeField {
public:
    /// Cells as large as the spacing of the heights, but at least 5 m and so large that there are a million
    /// at most [choice]. The slope of a cell is that of its height differences over two cells.
    SlopeField(const rockfall::Terrain& terrain, double spacing_m);

    [[nodiscard]] double cell_m() const { return frame_.cell_width_m; }
    [[nodiscard]] config::Cell cell_at(const Eigen::Vector2d& place_m) const {
        return frame_.cell_at(place_m.x(), place_m.y());
    }
    [[nodiscard]] Eigen::Vector2d middle_m() const {
        return {0.5 * (frame_.x_west_m + frame_.x_east_m()), 0.5 * (frame_.y_south_m + frame_.y_north_m())};
    }
    /// The cell on the other side of the middle, from west to east, from north to south, or both.
    [[nodiscard]] config::Cell mirrored(const config::Cell& cell, bool west_east, bool north_south) const {
        return {west_east ? frame_.columns - 1 - cell.column : cell.column,
                north_south ? frame_.rows - 1 - cell.row : cell.row};
    }
    /// A number of the cell; of all beyond the frame the same.
    [[nodiscard]] std::size_t place_of(const config::Cell& cell) const {
        return frame_.contains(cell) ? frame_.index(cell) : frame_.size();
    }
    /// The steepest slope of the cell and of those around it within 10 m, or of its eight neighbours where
    /// cells are larger [degrees]; NaN where the cell itself has no ground.
    [[nodiscard]] double steepest_deg(const config::Cell& cell) const {
        return frame_.contains(cell) ? steepest_deg_[frame_.index(cell)] : missing;
    }
    /// Of all cells, in the order of place_of().
    [[nodiscard]] const std::vector<double>& all_steepest_deg() const { return steepest_deg_; }

private:
    static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

    config::GridFrame frame_;
    std::vector<double> steepest_deg_;
};

}  // namespace coupling::plausible
