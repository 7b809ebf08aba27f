#include "coupling/inputs/grids/filled_holes.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "config/grid/holes.hpp"

namespace coupling::grids {
namespace {

/// The cells of a hole, which hang together over edges and corners, in row-major order.
std::vector<std::size_t> cells_of(const config::Raster<double>& grid, const config::Hole& hole) {
    std::vector<std::size_t> cells{hole.first_cell};
    std::vector<std::size_t> open{hole.first_cell};
    std::set<std::size_t> seen{hole.first_cell};
    while (!open.empty()) {
        const config::Cell cell = grid.frame.cell_of(open.back());
        open.pop_back();
        for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
            for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
                const std::size_t next = grid.frame.index({column, row});
                if (std::isnan(grid.values[next]) && seen.insert(next).second) {
                    cells.push_back(next);
                    open.push_back(next);
                }
            }
        }
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

void fill(config::Raster<double>& grid, const std::vector<std::size_t>& cells) {
    const config::GridFrame& frame = grid.frame;
    const double across = 1.0 / (frame.cell_width_m * frame.cell_width_m);
    const double along = 1.0 / (frame.cell_height_m * frame.cell_height_m);
    const auto place_in_hole = [&](std::size_t cell) {
        const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
        return found != cells.end() && *found == cell ? found - cells.begin() : std::ptrdiff_t{-1};
    };
    const auto count = static_cast<Eigen::Index>(cells.size());
    std::vector<Eigen::Triplet<double>> weights;
    Eigen::VectorXd known = Eigen::VectorXd::Zero(count);
    // Heights above one of the rim: large numbers would cost digits.
    double base_m = std::numeric_limits<double>::quiet_NaN();
    for (Eigen::Index i = 0; i < count; ++i) {
        const config::Cell cell = frame.cell_of(cells[static_cast<std::size_t>(i)]);
        const std::array<std::pair<config::Cell, double>, 4> neighbours{
            {{{cell.column, cell.row - 1}, along},
             {{cell.column - 1, cell.row}, across},
             {{cell.column + 1, cell.row}, across},
             {{cell.column, cell.row + 1}, along}}};
        weights.emplace_back(i, i, 2.0 * (across + along));
        for (const auto& [neighbour, weight] : neighbours) {
            const std::size_t index = frame.index(neighbour);
            if (const std::ptrdiff_t other = place_in_hole(index); other >= 0) {
                weights.emplace_back(i, other, -weight);
            } else {
                base_m = std::isnan(base_m) ? grid.values[index] : base_m;
                known[i] += weight * (grid.values[index] - base_m);
            }
        }
    }
    Eigen::SparseMatrix<double> matrix{count, count};
    matrix.setFromTriplets(weights.begin(), weights.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver{matrix};
    const Eigen::VectorXd heights_m = solver.solve(known);
    for (Eigen::Index i = 0; i < count; ++i) {
        grid.values[cells[static_cast<std::size_t>(i)]] = base_m + heights_m[i];
    }
}

/// The value of the nearest cell that has one, looked for in squares around a cell that grow.
double nearest_value(const config::Raster<double>& given, config::Cell cell, int most_cells) {
    const config::GridFrame& frame = given.frame;
    const double least_side_m = std::min(frame.cell_width_m, frame.cell_height_m);
    double nearest_m = std::numeric_limits<double>::infinity();
    std::size_t nearest = frame.index(cell);
    for (int away = 1; away <= most_cells && away * least_side_m <= nearest_m; ++away) {
        for (int row = cell.row - away; row <= cell.row + away; ++row) {
            const bool is_whole_row = std::abs(row - cell.row) == away;
            const int step = is_whole_row ? 1 : 2 * away;
            for (int column = cell.column - away; column <= cell.column + away; column += step) {
                if (!frame.contains({column, row}) || std::isnan(given.at({column, row}))) {
                    continue;
                }
                const double away_m = std::hypot((column - cell.column) * frame.cell_width_m,
                                                 (row - cell.row) * frame.cell_height_m);
                const std::size_t index = frame.index({column, row});
                if (std::tie(away_m, index) < std::tie(nearest_m, nearest)) {
                    nearest_m = away_m;
                    nearest = index;
                }
            }
        }
    }
    return given.values[nearest];
}

}  // namespace

FilledHoles fill_holes(config::Raster<double>& grid, double most_m2) {
    FilledHoles filled;
    if (!(most_m2 > 0.0)) {
        return filled;
    }
    for (const config::Hole& hole : config::holes_of(grid)) {
        if (static_cast<double>(hole.cells) * grid.frame.cell_area_m2() > most_m2 * (1.0 + 1e-9)) {
            continue;
        }
        const std::vector<std::size_t> cells = cells_of(grid, hole);
        fill(grid, cells);
        filled.cells.insert(filled.cells.end(), cells.begin(), cells.end());
        ++filled.holes;
    }
    std::sort(filled.cells.begin(), filled.cells.end());
    return filled;
}

void take_nearest(config::Raster<double>& codes, const std::vector<std::size_t>& cells, int most_cells) {
    const config::Raster<double> given = codes;
    for (const std::size_t index : cells) {
        if (std::isnan(given.values[index])) {
            codes.values[index] = nearest_value(given, given.frame.cell_of(index), most_cells);
        }
    }
}

}  // namespace coupling::grids
