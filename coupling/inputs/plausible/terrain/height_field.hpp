#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "config/grid/raster.hpp"

namespace coupling::plausible::terrain {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Heights on a grid, as every rule on heights reads them. NaN where the ground is not known.
struct HeightField {
    int rows = 0;
    int columns = 0;
    double column_spacing_m = 1.0;  ///< between neighbours of a row
    double row_spacing_m = 1.0;     ///< between neighbours of a column
    const double* heights_m = nullptr;

    [[nodiscard]] double at(int row, int column) const {
        return heights_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(column)];
    }
    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    }
    [[nodiscard]] double cell_m() const { return std::sqrt(column_spacing_m * row_spacing_m); }
};

/// The field does not own its heights: the grid must outlive it.
inline HeightField field_of(const config::Raster<double>& grid) {
    return {.rows = grid.frame.rows,
            .columns = grid.frame.columns,
            .column_spacing_m = grid.frame.cell_width_m,
            .row_spacing_m = grid.frame.cell_height_m,
            .heights_m = grid.values.data()};
}

/// One of the two directions of a grid, so that a rule is written once and looks along both.
struct Axis {
    int lines = 0;  ///< rows, or columns
    int cells = 0;  ///< of one line
    std::ptrdiff_t line_step = 0;
    std::ptrdiff_t cell_step = 0;
    double spacing_m = 1.0;       ///< between neighbours of a line
    double line_spacing_m = 1.0;  ///< between neighbouring lines
};

inline Axis along_rows(const HeightField& field) {
    return {field.rows, field.columns, field.columns, 1, field.column_spacing_m, field.row_spacing_m};
}
inline Axis along_columns(const HeightField& field) {
    return {field.columns, field.rows, 1, field.columns, field.row_spacing_m, field.column_spacing_m};
}

/// Calls `visit(line, i, cell)` for the cells `first` to `end` - 1 of every line, in the order of memory:
/// down the columns of a large grid the other order takes ten times as long.
template <class Visit>
void visit_cells(const HeightField& field, const Axis& axis, int first, int end, Visit visit) {
    if (axis.cell_step == 1) {
        for (int line = 0; line < axis.lines; ++line) {
            const double* cell = field.heights_m + line * axis.line_step + first;
            for (int i = first; i < end; ++i, ++cell) {
                visit(line, i, cell);
            }
        }
        return;
    }
    for (int i = first; i < end; ++i) {
        const double* cell = field.heights_m + i * axis.cell_step;
        for (int line = 0; line < axis.lines; ++line, cell += axis.line_step) {
            visit(line, i, cell);
        }
    }
}

/// What all rules may ask of the values themselves.
struct Values {
    std::size_t known = 0;
    double low_m = 0.0;
    double high_m = 0.0;
    bool all_whole = false;  ///< whole numbers only
};

Values values_of(const HeightField& field);

/// The whole number of metres (or half a metre) of which all heights are multiples; 0 without one. Looks at
/// no more than 5000 different heights: a terrain of more of them has no steps.
double step_of_heights_m(const HeightField& field);

}  // namespace coupling::plausible::terrain
