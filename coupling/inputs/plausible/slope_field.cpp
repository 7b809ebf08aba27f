#include "coupling/inputs/plausible/slope_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/inputs/systems/extent.hpp"

namespace coupling::plausible {
namespace {

constexpr double smallest_cell_m = 5.0;
constexpr double most_cells = 1e6;
constexpr double around_m = 10.0;

/// Square cells over a terrain whose middle is that of the extent.
config::GridFrame middle_frame(const rockfall::Terrain& terrain, double spacing_m) {
    const Extent extent = extent_of(terrain);
    const double width_m = extent.east_m - extent.west_m;
    const double height_m = extent.north_m - extent.south_m;
    const double cell_m = std::max({smallest_cell_m, spacing_m, std::sqrt(width_m * height_m / most_cells)});
    config::GridFrame frame;
    frame.columns = std::max(1, static_cast<int>(std::ceil(width_m / cell_m - 1e-9)));
    frame.rows = std::max(1, static_cast<int>(std::ceil(height_m / cell_m - 1e-9)));
    frame.cell_width_m = cell_m;
    frame.cell_height_m = cell_m;
    const Eigen::Vector2d origin_m = terrain.origin_m();
    frame.x_west_m = 0.5 * (extent.west_m + extent.east_m) - origin_m.x() - 0.5 * cell_m * frame.columns;
    frame.y_south_m = 0.5 * (extent.south_m + extent.north_m) - origin_m.y() - 0.5 * cell_m * frame.rows;
    return frame;
}

/// Differences over two cells, or over one beside a border.
double gradient(double before_m, double here_m, double after_m, double cell_m) {
    const bool has_before = !std::isnan(before_m);
    const bool has_after = !std::isnan(after_m);
    if (has_before && has_after) {
        return (after_m - before_m) / (2.0 * cell_m);
    }
    return has_after    ? (after_m - here_m) / cell_m
           : has_before ? (here_m - before_m) / cell_m
                        : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

SlopeField::SlopeField(const rockfall::Terrain& terrain, double spacing_m)
    : frame_{middle_frame(terrain, spacing_m)}, steepest_deg_(frame_.size(), missing) {
    config::Raster<double> heights_m{frame_, missing};
    std::uint32_t near = rockfall::no_triangle;
    for (std::size_t i = 0; i < heights_m.values.size(); ++i) {
        const config::Cell cell = frame_.cell_of(i);
        const double x_m = frame_.x_centre_m(cell.column);
        const double y_m = frame_.y_centre_m(cell.row);
        if (const auto triangle =
                near == rockfall::no_triangle ? terrain.locate(x_m, y_m) : terrain.locate(x_m, y_m, near)) {
            near = *triangle;
            heights_m.values[i] = terrain.plane_of(*triangle).height_m(x_m, y_m);
        }
    }
    const auto height_m = [&](int column, int row) {
        return frame_.contains({column, row}) ? heights_m.at({column, row}) : missing;
    };
    std::vector<double> slopes_deg(frame_.size(), missing);
    for (std::size_t i = 0; i < slopes_deg.size(); ++i) {
        const auto [column, row] = frame_.cell_of(i);
        const double here_m = heights_m.values[i];
        const double east = gradient(height_m(column - 1, row), here_m, height_m(column + 1, row), cell_m());
        const double south = gradient(height_m(column, row - 1), here_m, height_m(column, row + 1), cell_m());
        slopes_deg[i] = std::atan(std::hypot(east, south)) * 180.0 / std::numbers::pi;
    }
    const int around = std::max(1, static_cast<int>(std::floor(around_m / cell_m())));
    for (std::size_t i = 0; i < slopes_deg.size(); ++i) {
        if (std::isnan(heights_m.values[i])) {
            continue;
        }
        const config::Cell cell = frame_.cell_of(i);
        for (int row = cell.row - around; row <= cell.row + around; ++row) {
            for (int column = cell.column - around; column <= cell.column + around; ++column) {
                if (frame_.contains({column, row})) {
                    // fmax passes over what is missing.
                    steepest_deg_[i] = std::fmax(steepest_deg_[i], slopes_deg[frame_.index({column, row})]);
                }
            }
        }
    }
}

}  // namespace coupling::plausible
