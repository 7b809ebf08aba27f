#include "coupling/assessments/decades/report/forest_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::decades {
namespace {

constexpr double most_whole_ha = 1.5;
constexpr double most_whole_m = 200.0;
constexpr int window_cells = 10;
constexpr double half_transect_m = 50.0;
/// Tangent of the mean slope below which a forest counts as flat.
constexpr double flat = 0.02;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Gradient {
    double per_x = 0.0;
    double per_y = 0.0;
};

Gradient gradient_of(const forest::Patch& patch) {
    const double steepness = std::tan(patch.slope.in_radians());
    // The aspect is where the slope faces: down.
    return {-steepness * std::sin(patch.aspect.in_radians()),
            -steepness * std::cos(patch.aspect.in_radians())};
}

config::GridFrame part_of(const config::GridFrame& frame, config::Cell north_west, int columns, int rows) {
    config::GridFrame part = frame;
    part.columns = columns;
    part.rows = rows;
    part.x_west_m = frame.x_west_m + north_west.column * frame.cell_width_m;
    part.y_south_m = frame.y_north_m() - (north_west.row + rows) * frame.cell_height_m;
    return part;
}

int patches_in(const forest::PatchGrid& grid, config::Cell north_west) {
    int patches = 0;
    for (int row = 0; row < window_cells; ++row) {
        for (int column = 0; column < window_cells; ++column) {
            patches += grid.at(config::Cell{north_west.column + column, north_west.row + row}) ? 1 : 0;
        }
    }
    return patches;
}

double middle_x_m(const config::GridFrame& frame) {
    return 0.5 * (frame.x_west_m + frame.x_east_m());
}
double middle_y_m(const config::GridFrame& frame) {
    return 0.5 * (frame.y_south_m + frame.y_north_m());
}

}  // namespace

ForestGround::ForestGround(const forest::PatchGrid& grid) {
    const config::GridFrame& inner = grid.frame();
    heights_ = config::Raster<double>{part_of(inner, {-1, -1}, inner.columns + 2, inner.rows + 2), nothing};
    config::Raster<double> sums{heights_.frame, 0.0};
    config::Raster<int> neighbours{heights_.frame, 0};
    for (const forest::Patch& patch : grid.patches()) {
        const Gradient gradient = gradient_of(patch);
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const config::Cell cell{patch.cell.column + 1 + dx, patch.cell.row + 1 + dy};
                sums.at(cell) +=
                    patch.ground_m + forest::patch_side_m * (dx * gradient.per_x - dy * gradient.per_y);
                ++neighbours.at(cell);
            }
        }
    }
    for (std::size_t i = 0; i < sums.values.size(); ++i) {
        heights_.values[i] = neighbours.values[i] > 0 ? sums.values[i] / neighbours.values[i] : nothing;
    }
    for (const forest::Patch& patch : grid.patches()) {
        heights_.at({patch.cell.column + 1, patch.cell.row + 1}) = patch.ground_m;
    }
}

double ForestGround::height_m(double x_m, double y_m) const {
    const config::GridFrame& frame = heights_.frame;
    const double column = (x_m - frame.x_west_m) / frame.cell_width_m - 0.5;
    const double row = (frame.y_north_m() - y_m) / frame.cell_height_m - 0.5;
    const config::Cell cell{static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row))};
    if (!frame.contains(cell) || !frame.contains({cell.column + 1, cell.row + 1})) {
        return nothing;
    }
    const auto along_row = [&](int r) {
        return std::lerp(heights_.at({cell.column, r}), heights_.at({cell.column + 1, r}),
                         column - cell.column);
    };
    return std::lerp(along_row(cell.row), along_row(cell.row + 1), row - cell.row);
}

config::GridFrame extent_of(const forest::PatchGrid& grid) {
    config::Cell first = grid.patches().front().cell;
    config::Cell last = first;
    for (const forest::Patch& patch : grid.patches()) {
        first = {std::min(first.column, patch.cell.column), std::min(first.row, patch.cell.row)};
        last = {std::max(last.column, patch.cell.column), std::max(last.row, patch.cell.row)};
    }
    return part_of(grid.frame(), first, last.column - first.column + 1, last.row - first.row + 1);
}

StandWindow window_of(const forest::PatchGrid& grid) {
    const config::GridFrame extent = extent_of(grid);
    const double longest_m =
        std::max(extent.x_east_m() - extent.x_west_m, extent.y_north_m() - extent.y_south_m);
    if (grid.area_ha() <= most_whole_ha && longest_m <= most_whole_m) {
        return {extent, true};
    }
    StandWindow best{extent, false};
    int most = 0;
    double nearest_m = 0.0;
    for (const forest::Patch& patch : grid.patches()) {
        const config::Cell north_west{patch.cell.column - window_cells / 2,
                                      patch.cell.row - window_cells / 2};
        const config::GridFrame frame = part_of(grid.frame(), north_west, window_cells, window_cells);
        const int patches = patches_in(grid, north_west);
        const double away_m =
            std::hypot(middle_x_m(frame) - middle_x_m(extent), middle_y_m(frame) - middle_y_m(extent));
        if (patches > most || (patches == most && away_m < nearest_m)) {
            best.frame = frame;
            most = patches;
            nearest_m = away_m;
        }
    }
    return best;
}

Transect transect_of(const forest::PatchGrid& grid, const StandWindow& window) {
    const double x_m = middle_x_m(window.frame);
    const double y_m = middle_y_m(window.frame);
    Gradient mean;
    double patches = 0.0;
    double nearest_m = std::numeric_limits<double>::infinity();
    Transect transect;
    for (std::uint32_t p = 0; p < grid.size(); ++p) {
        const forest::PatchId id{p};
        const double px_m = grid.x_centre_m(id);
        const double py_m = grid.y_centre_m(id);
        if (!window.frame.covers(px_m, py_m)) {
            continue;
        }
        const Gradient gradient = gradient_of(grid[id]);
        patches += 1.0;
        mean.per_x += gradient.per_x;
        mean.per_y += gradient.per_y;
        if (const double away_m = std::hypot(px_m - x_m, py_m - y_m); away_m < nearest_m) {
            nearest_m = away_m;
            transect.x_m = px_m;
            transect.y_m = py_m;
        }
    }
    if (grid.at(x_m, y_m)) {
        transect.x_m = x_m;
        transect.y_m = y_m;
    }
    const double steepness = std::hypot(mean.per_x, mean.per_y);
    transect.falls = steepness > flat * patches;
    if (transect.falls) {
        transect.along_x = -mean.per_x / steepness;
        transect.along_y = -mean.per_y / steepness;
    }
    const auto reach_m = [&](double sign) {
        double reached_m = 0.0;
        while (reached_m < half_transect_m &&
               grid.at(transect.x_at(sign * (reached_m + 1.0)), transect.y_at(sign * (reached_m + 1.0)))) {
            reached_m += 1.0;
        }
        return reached_m;
    };
    const double up_m = reach_m(-1.0);
    transect.length_m = up_m + reach_m(1.0);
    transect.x_m = transect.x_at(-up_m);
    transect.y_m = transect.y_at(-up_m);
    return transect;
}

}  // namespace coupling::decades
