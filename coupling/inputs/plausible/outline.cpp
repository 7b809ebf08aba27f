#include "coupling/inputs/plausible/outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace coupling::plausible {
namespace {

/// Cells with a rim of unknown ones, as bytes.
class Mask {
public:
    Mask(const config::Raster<double>& cells, int rim)
        : columns_{cells.frame.columns + 2 * rim},
          rows_{cells.frame.rows + 2 * rim},
          set_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {
        for (std::size_t i = 0; i < cells.values.size(); ++i) {
            const config::Cell cell = cells.frame.cell_of(i);
            set_[index(cell.column + rim, cell.row + rim)] = std::isnan(cells.values[i]) ? 0 : 1;
        }
    }

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] bool at(int column, int row) const { return set_[index(column, row)] != 0; }

    /// Sets each cell that a set one lies within n columns and rows of.
    void grow(int n) { look_around(n, 1); }
    /// Takes away each cell that one which is not set, or the border of the mask, lies so near to.
    void shrink(int n) { look_around(n, 0); }

    /// Sets what cannot be reached from the rim over cells that are not set, along edges and corners.
    void fill_enclosed() {
        constexpr std::uint8_t outside = 2;
        std::vector<std::size_t> open{0};
        set_[0] = outside;
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            const int column = static_cast<int>(at % static_cast<std::size_t>(columns_));
            const int row = static_cast<int>(at / static_cast<std::size_t>(columns_));
            for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
                for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
                    if (set_[index(c, r)] == 0) {
                        set_[index(c, r)] = outside;
                        open.push_back(index(c, r));
                    }
                }
            }
        }
        for (std::uint8_t& cell : set_) {
            cell = cell == outside ? 0 : 1;
        }
    }

private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    /// Gives each cell the value that one of its row, then of its column, within n has. Beyond the mask
    /// nothing is set.
    void look_around(int n, std::uint8_t value) {
        for (int row = 0; row < rows_; ++row) {
            spread(index(0, row), 1, columns_, n, value);
        }
        for (int column = 0; column < columns_; ++column) {
            spread(index(column, 0), static_cast<std::size_t>(columns_), rows_, n, value);
        }
    }

    void spread(std::size_t first, std::size_t step, int count, int n, std::uint8_t value) {
        line_.resize(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            line_[static_cast<std::size_t>(i)] = set_[first + static_cast<std::size_t>(i) * step];
        }
        int until = value == 0 ? n : 0;  // cells before this one get the value; beyond the mask lie zeros
        int next = 0;
        for (int i = 0; i < count; ++i) {
            for (; next < std::min(count, i + n + 1); ++next) {
                if (line_[static_cast<std::size_t>(next)] == value) {
                    until = std::max(until, next + n + 1);
                }
            }
            const bool near_end = value == 0 && i + n >= count;
            if (i < until || near_end) {
                set_[first + static_cast<std::size_t>(i) * step] = value;
            }
        }
    }

    int columns_;
    int rows_;
    std::vector<std::uint8_t> set_;
    std::vector<std::uint8_t> line_;
};

constexpr int window = 2;  // cells to each side, in which the density of known ones is counted

/// Mean share of known cells among those around a known one, of those that lie in the grid.
double density_of(const config::Raster<double>& cells) {
    double sum = 0.0;
    double known = 0.0;
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
        if (std::isnan(cells.values[i])) {
            continue;
        }
        const config::Cell cell = cells.frame.cell_of(i);
        int here = -1;  // not the cell itself
        int all = -1;
        for (int row = cell.row - window; row <= cell.row + window; ++row) {
            for (int column = cell.column - window; column <= cell.column + window; ++column) {
                if (cells.frame.contains({column, row})) {
                    ++all;
                    here += std::isnan(cells.at({column, row})) ? 0 : 1;
                }
            }
        }
        sum += all > 0 ? static_cast<double>(here) / all : 0.0;
        known += 1.0;
    }
    return known > 0.0 ? sum / known : 0.0;
}

/// Half of the widest gap that is none of a border.
int half_gap(double density) {
    constexpr double distances = 2.0;  // [choice] of the scattered cells one in 10 million lies beside a hole
    constexpr double most = 40.0;
    return static_cast<int>(std::ceil(std::min(most, distances / std::sqrt(std::max(density, 1e-6))) - 1e-9));
}

}  // namespace

Outline outline_of(const config::Raster<double>& cells) {
    const config::GridFrame& frame = cells.frame;
    const bool is_whole = std::none_of(cells.values.begin(), cells.values.end(),
                                       [](double value) { return std::isnan(value); });
    if (is_whole) {
        return {(frame.columns - 1.0) * (frame.rows - 1.0) * frame.cell_area_m2(), 0.0};
    }
    const int n = half_gap(density_of(cells));
    const int rim = 2 * n + 1;
    Mask inside{cells, rim};
    inside.grow(n);
    inside.shrink(n);
    inside.fill_enclosed();
    double halves = 0.0;
    double all = 0.0;
    std::size_t unknown = 0;
    for (int row = 0; row < inside.rows(); ++row) {
        for (int column = 0; column < inside.columns(); ++column) {
            if (inside.at(column, row)) {
                const config::Cell cell{column - rim, row - rim};
                all += 1.0;
                unknown += !frame.contains(cell) || std::isnan(cells.at(cell)) ? 1 : 0;
            }
            if (column + 1 < inside.columns() && row + 1 < inside.rows()) {
                const int corners = inside.at(column, row) + inside.at(column + 1, row) +
                                    inside.at(column, row + 1) + inside.at(column + 1, row + 1);
                halves += corners == 4 ? 2.0 : corners == 3 ? 1.0 : 0.0;
            }
        }
    }
    return {0.5 * halves * frame.cell_area_m2(), all > 0.0 ? static_cast<double>(unknown) / all : 0.0,
            unknown};
}

}  // namespace coupling::plausible
