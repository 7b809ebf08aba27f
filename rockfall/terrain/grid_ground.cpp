#include "rockfall/terrain/grid_ground.hpp"

#include <cmath>
#include <cstdlib>

namespace rockfall {
namespace {

bool is_known(const config::Raster<double>& heights, config::Cell cell) {
    return heights.frame.contains(cell) && std::isfinite(heights.at(cell));
}

bool is_corner(const config::GridFrame& frame, config::Cell cell) {
    return (cell.column == 0 || cell.column == frame.columns - 1) &&
           (cell.row == 0 || cell.row == frame.rows - 1);
}

bool touches_hole(const config::Raster<double>& heights, config::Cell cell) {
    for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
        for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
            const config::Cell neighbour{column, row};
            if (heights.frame.contains(neighbour) && !is_known(heights, neighbour)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

bool lies_on_ground(const config::Raster<double>& heights, config::Cell a, config::Cell b, config::Cell c) {
    // The centroid in thirds of a cell, its square and its place therein: whole numbers, so exact.
    const int column_thirds = a.column + b.column + c.column;
    const int row_thirds = a.row + b.row + c.row;
    const config::Cell square{column_thirds / 3, row_thirds / 3};
    const config::Cell inside{column_thirds % 3, row_thirds % 3};

    int missing = 0;
    int thirds_to_missing = 0;
    for (const config::Cell corner : {config::Cell{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        if (!is_known(heights, {square.column + corner.column, square.row + corner.row})) {
            ++missing;
            thirds_to_missing =
                std::abs(inside.column - 3 * corner.column) + std::abs(inside.row - 3 * corner.row);
        }
    }
    return missing == 0 || (missing == 1 && thirds_to_missing > 3);
}

std::vector<config::Cell> outline_cells(const config::Raster<double>& heights) {
    std::vector<config::Cell> cells;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = heights.frame.cell_of(i);
        if (is_known(heights, cell) && (is_corner(heights.frame, cell) || touches_hole(heights, cell))) {
            cells.push_back(cell);
        }
    }
    return cells;
}

}  // namespace rockfall
