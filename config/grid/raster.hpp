#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace config {

/// Column and row of a grid cell; row 0 is the northern edge, column 0 the western one.
struct Cell {
    int column = 0;
    int row = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
};

/// Where a grid lies and how large its cells are.
///
///            y_north_m ┌──┬──┬──┐
///                row 0 │  │  │  │
///                      ├──┼──┼──┤
///                row 1 │  │  │  │
///            y_south_m └──┴──┴──┘
///                      ^ x_west_m; column 0, 1, 2
struct GridFrame {
    int columns = 0;
    int rows = 0;
    double x_west_m = 0.0;   ///< outer western edge
    double y_south_m = 0.0;  ///< outer southern edge
    double cell_width_m = 1.0;
    double cell_height_m = 1.0;

    friend bool operator==(const GridFrame&, const GridFrame&) = default;

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    [[nodiscard]] double x_east_m() const { return x_west_m + columns * cell_width_m; }
    [[nodiscard]] double y_north_m() const { return y_south_m + rows * cell_height_m; }
    [[nodiscard]] double cell_area_m2() const { return cell_width_m * cell_height_m; }
    [[nodiscard]] double x_centre_m(int column) const { return x_west_m + (column + 0.5) * cell_width_m; }
    [[nodiscard]] double y_centre_m(int row) const { return y_south_m + (rows - row - 0.5) * cell_height_m; }
    [[nodiscard]] bool contains(Cell cell) const {
        return cell.column >= 0 && cell.column < columns && cell.row >= 0 && cell.row < rows;
    }
    [[nodiscard]] bool covers(double x_m, double y_m) const {
        return x_m >= x_west_m && x_m < x_east_m() && y_m > y_south_m && y_m <= y_north_m();
    }
    /// The cell that a point lies in; outside the grid it names a cell that `contains` refuses.
    [[nodiscard]] Cell cell_at(double x_m, double y_m) const {
        return {static_cast<int>(std::floor((x_m - x_west_m) / cell_width_m)),
                static_cast<int>(std::floor((y_north_m() - y_m) / cell_height_m))};
    }
    /// Place of a cell in row-major order from the north-west. Requires contains(cell).
    [[nodiscard]] std::size_t index(Cell cell) const {
        assert(contains(cell));
        return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(cell.column);
    }
    [[nodiscard]] Cell cell_of(std::size_t index) const {
        return {static_cast<int>(index % static_cast<std::size_t>(columns)),
                static_cast<int>(index / static_cast<std::size_t>(columns))};
    }
};

/// Same corner, counts and cell size within a hundredth of a cell over the whole extent.
[[nodiscard]] inline bool same_place(const GridFrame& a, const GridFrame& b) {
    const double slack_x_m = 0.01 * a.cell_width_m;
    const double slack_y_m = 0.01 * a.cell_height_m;
    return a.columns == b.columns && a.rows == b.rows && std::abs(a.x_west_m - b.x_west_m) <= slack_x_m &&
           std::abs(a.y_south_m - b.y_south_m) <= slack_y_m &&
           std::abs(a.x_east_m() - b.x_east_m()) <= slack_x_m &&
           std::abs(a.y_north_m() - b.y_north_m()) <= slack_y_m;
}

/// Values on a grid, row by row from the north-west.
template <class T>
struct Raster {
    GridFrame frame;
    std::vector<T> values;

    Raster() = default;
    explicit Raster(const GridFrame& frame_in, T fill = T{})
        : frame{frame_in}, values(frame_in.size(), fill) {}

    [[nodiscard]] T& at(Cell cell) { return values[frame.index(cell)]; }
    [[nodiscard]] const T& at(Cell cell) const { return values[frame.index(cell)]; }
};

}  // namespace config
