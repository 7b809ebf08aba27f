#include "rockfall/terrain/vertical_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace rockfall {
namespace {

/// Quotient rounded down. Requires divisor > 0.
std::int64_t divide_down(std::int64_t value, std::int64_t divisor) {
    const std::int64_t quotient = value / divisor;
    return quotient * divisor > value ? quotient - 1 : quotient;
}

std::int64_t divide_up(std::int64_t value, std::int64_t divisor) {
    return -divide_down(-value, divisor);
}

struct Columns {
    std::int64_t first = std::numeric_limits<std::int64_t>::max();
    std::int64_t last = std::numeric_limits<std::int64_t>::min();
};

/// Columns whose centres lie in the triangle on one row, in whole numbers and so exact. Requires a row
/// between its corners.
Columns columns_on_row(const std::array<config::Cell, 3>& corners, int row) {
    Columns columns;
    for (std::size_t i = 0; i < 3; ++i) {
        config::Cell from = corners[i];
        config::Cell to = corners[(i + 1) % 3];
        if (from.row > to.row) {
            std::swap(from, to);
        }
        if (row < from.row || row > to.row) {
            continue;
        }
        const std::int64_t rows = to.row - from.row;
        const std::int64_t shift = static_cast<std::int64_t>(to.column - from.column) * (row - from.row);
        columns.first = std::min(columns.first, from.column + (rows > 0 ? divide_up(shift, rows) : 0));
        columns.last = std::max(columns.last, from.column + (rows > 0 ? divide_down(shift, rows) : 0));
    }
    return columns;
}

/// A plane over the grid, by column and row.
struct GridPlane {
    config::Cell corner;
    double height_m;
    double per_column_m;
    double per_row_m;

    [[nodiscard]] double height_at_m(int column, int row) const {
        return height_m + per_column_m * (column - corner.column) + per_row_m * (row - corner.row);
    }
};

GridPlane plane_through(const config::Raster<double>& heights, const std::array<config::Cell, 3>& corners) {
    const auto [a, b, c] = corners;
    const double bx = b.column - a.column, by = b.row - a.row, bz = heights.at(b) - heights.at(a);
    const double cx = c.column - a.column, cy = c.row - a.row, cz = heights.at(c) - heights.at(a);
    const double area2 = bx * cy - by * cx;
    return {a, heights.at(a), (bz * cy - cz * by) / area2, (cz * bx - bz * cx) / area2};
}

}  // namespace

VerticalError largest_vertical_error(const config::Raster<double>& heights,
                                     const std::array<config::Cell, 3>& corners) {
    const GridPlane plane = plane_through(heights, corners);
    const auto [north, south] = std::minmax({corners[0].row, corners[1].row, corners[2].row});
    VerticalError largest;
    for (int row = north; row <= south; ++row) {
        const Columns columns = columns_on_row(corners, row);
        for (int column = static_cast<int>(columns.first); column <= columns.last; ++column) {
            const config::Cell cell{column, row};
            const double error_m = std::abs(heights.at(cell) - plane.height_at_m(column, row));
            // A missing cell gives NaN, which is not larger; the corners' own rounding is no error.
            if (error_m > largest.error_m &&
                std::find(corners.begin(), corners.end(), cell) == corners.end()) {
                largest = {error_m, cell};
            }
        }
    }
    return largest;
}

}  // namespace rockfall
