#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/grid/raster.hpp"

namespace rockfall {

/// A grid cell and what lies well inside it; of none there is nothing inside.
struct CellInside {
    config::Cell cell{};
    double west_m = 0.0;
    double east_m = -1.0;
    double south_m = 0.0;
    double north_m = -1.0;

    CellInside() = default;
    CellInside(const config::GridFrame& frame, const config::Cell& in) : cell{in} {
        // A path that comes so near to the border may leave by rounding.
        constexpr double border_share = 1e-6;
        const double x_border_m = border_share * frame.cell_width_m;
        const double y_border_m = border_share * frame.cell_height_m;
        west_m = frame.x_west_m + cell.column * frame.cell_width_m + x_border_m;
        east_m = frame.x_west_m + (cell.column + 1) * frame.cell_width_m - x_border_m;
        south_m = frame.y_north_m() - (cell.row + 1) * frame.cell_height_m + y_border_m;
        north_m = frame.y_north_m() - cell.row * frame.cell_height_m - y_border_m;
    }
    [[nodiscard]] bool has(double x_m, double y_m) const {
        return x_m > west_m && x_m < east_m && y_m > south_m && y_m < north_m;
    }
};

/// The straight plan view of a path as it goes from grid cell to grid cell.
class CellSteps {
public:
    /// Stays where it is.
    explicit CellSteps(const config::Cell& cell) : cell_{cell}, step_column_{1}, step_row_{1} {}
    CellSteps(const config::GridFrame& frame, double x_m, double y_m, double vx, double vy)
        : CellSteps{frame, frame.cell_at(x_m, y_m), x_m, y_m, vx, vy} {}
    /// Starts in a cell that is known.
    CellSteps(const config::GridFrame& frame, const config::Cell& start, double x_m, double y_m, double vx,
              double vy)
        : cell_{start}, step_column_{vx >= 0.0 ? 1 : -1}, step_row_{vy >= 0.0 ? -1 : 1} {
        if (vx != 0.0) {
            const double border_m = frame.x_west_m + (cell_.column + (vx > 0.0 ? 1 : 0)) * frame.cell_width_m;
            const double per_vx = 1.0 / vx;
            to_column_ = (border_m - x_m) * per_vx;
            per_column_ = frame.cell_width_m * std::abs(per_vx);
        }
        if (vy != 0.0) {
            const double border_m =
                frame.y_north_m() - (cell_.row + (vy > 0.0 ? 0 : 1)) * frame.cell_height_m;
            const double per_vy = 1.0 / vy;
            to_row_ = (border_m - y_m) * per_vy;
            per_row_ = frame.cell_height_m * std::abs(per_vy);
        }
    }
    [[nodiscard]] const config::Cell& cell() const { return cell_; }
    [[nodiscard]] double end() const { return std::min(to_column_, to_row_); }
    void next() {
        if (to_column_ <= to_row_) {
            cell_.column += step_column_;
            to_column_ += per_column_;
        } else {
            cell_.row += step_row_;
            to_row_ += per_row_;
        }
    }

private:
    config::Cell cell_;
    int step_column_;
    int step_row_;
    double to_column_ = std::numeric_limits<double>::infinity();
    double to_row_ = std::numeric_limits<double>::infinity();
    double per_column_ = std::numeric_limits<double>::infinity();
    double per_row_ = std::numeric_limits<double>::infinity();
};

}  // namespace rockfall
