#include "rockfall/tally/release_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockfall {
namespace {

int cells_on_each_side(double width_m, double cell_m) {
    constexpr double rounding = 1e-9;  // 15 m are three cells of 5 m
    return std::max(0, static_cast<int>(std::ceil(0.5 * (width_m / cell_m - 1.0) - rounding)));
}

}  // namespace

CellReach reach_of_width(double width_m, const config::GridFrame& frame) {
    return {cells_on_each_side(width_m, frame.cell_width_m),
            cells_on_each_side(width_m, frame.cell_height_m)};
}

void ReleaseWindow::note(std::size_t cell, float energy_j, const config::GridFrame& frame, CellReach reach) {
    energy_j_.grow_to(frame.size());
    const config::Cell middle = frame.cell_of(cell);
    // A rock without energy came there, too.
    const float noted_j = std::max(energy_j, std::numeric_limits<float>::min());
    const int last_row = std::min(frame.rows - 1, middle.row + reach.rows);
    const int last_column = std::min(frame.columns - 1, middle.column + reach.columns);
    for (int row = std::max(0, middle.row - reach.rows); row <= last_row; ++row) {
        for (int column = std::max(0, middle.column - reach.columns); column <= last_column; ++column) {
            const std::size_t other = frame.index({column, row});
            if (energy_j_[other] == 0.0F) {
                cells_.push_back(other);
            }
            energy_j_[other] = std::max(energy_j_[other], noted_j);
        }
    }
}

}  // namespace rockfall
