#include "coupling/program/actions/steep_cells.hpp"

#include <cmath>
#include <numbers>

namespace coupling {

double source_slope_deg(double cell_size_m) {
    return 55.0 * std::pow(cell_size_m, -0.075);
}

SteepCells cells_steeper_than(double slope_deg, const config::Raster<double>& heights_m) {
    const config::GridFrame& frame = heights_m.frame;
    const double least_rise = std::tan(slope_deg * std::numbers::pi / 180.0);
    SteepCells steep{config::Raster<double>{frame, 0.0}};
    for (int row = 1; row + 1 < frame.rows; ++row) {
        for (int column = 1; column + 1 < frame.columns; ++column) {
            const double east = heights_m.at({column + 1, row}) - heights_m.at({column - 1, row});
            const double north = heights_m.at({column, row - 1}) - heights_m.at({column, row + 1});
            const double rise =
                std::hypot(east / (2.0 * frame.cell_width_m), north / (2.0 * frame.cell_height_m));
            if (rise > least_rise && !std::isnan(heights_m.at({column, row}))) {  // false where unknown
                steep.marks.at({column, row}) = 1.0;
                ++steep.count;
            }
        }
    }
    return steep;
}

}  // namespace coupling
