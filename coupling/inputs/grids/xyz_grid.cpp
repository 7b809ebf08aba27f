#include "coupling/inputs/grids/xyz_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::grids {
namespace {

/// Places along one axis at which cells may have their centres.
struct Lattice {
    double first_m = 0.0;
    double step_m = 1.0;
    int count = 0;

    /// The number of the centre at a coordinate; nothing where there is none.
    [[nodiscard]] std::optional<int> at(double value_m) const {
        constexpr double slack = 0.01;  // of a cell, as for grids (config::same_place)
        const double steps = (value_m - first_m) / step_m;
        const double nearest = std::round(steps);
        return std::abs(steps - nearest) <= slack ? std::optional{static_cast<int>(nearest)} : std::nullopt;
    }
};

std::optional<Lattice> lattice_of(std::vector<double> values_m) {
    constexpr double least_step_m = 0.01;  // below, coordinates are one with other digits [choice]
    constexpr double most = 1e6;           // centres along an axis
    std::sort(values_m.begin(), values_m.end());
    double step_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < values_m.size(); ++i) {
        const double gap_m = values_m[i] - values_m[i - 1];
        step_m = gap_m >= least_step_m ? std::min(step_m, gap_m) : step_m;
    }
    const double length_m = values_m.empty() ? 0.0 : values_m.back() - values_m.front();
    const double steps = std::round(length_m / step_m);
    if (!std::isfinite(step_m) || !(steps >= 1.0) || steps > most) {
        return std::nullopt;
    }
    return Lattice{values_m.front(), length_m / steps, static_cast<int>(steps) + 1};
}

/// Cells are square where the digits of the coordinates alone make them differ.
void make_square(Lattice& east, Lattice& north) {
    constexpr double slack = 0.01;  // of a cell, over the whole grid
    const double most = std::max(east.count, north.count);
    if (std::abs(east.step_m - north.step_m) * most <= slack * east.step_m) {
        const double mean_m = 0.5 * (east.step_m + north.step_m);
        east.step_m = mean_m;
        north.step_m = mean_m;
    }
}

}  // namespace

std::optional<config::Raster<double>> grid_of_points(const std::vector<Eigen::Vector3d>& points) {
    std::vector<double> values_m;
    values_m.reserve(points.size());
    const auto along = [&](int axis) {
        values_m.clear();
        for (const Eigen::Vector3d& point : points) {
            values_m.push_back(point[axis]);
        }
        return lattice_of(values_m);
    };
    auto east = along(0);
    auto north = along(1);
    constexpr std::size_t most_cells_per_point = 4;
    if (!east || !north ||
        static_cast<std::size_t>(east->count) * static_cast<std::size_t>(north->count) >
            most_cells_per_point * points.size()) {
        return std::nullopt;
    }
    make_square(*east, *north);
    config::GridFrame frame;
    frame.columns = east->count;
    frame.rows = north->count;
    frame.cell_width_m = east->step_m;
    frame.cell_height_m = north->step_m;
    frame.x_west_m = east->first_m - 0.5 * east->step_m;
    frame.y_south_m = north->first_m - 0.5 * north->step_m;
    config::Raster<double> grid{frame, std::numeric_limits<double>::quiet_NaN()};
    for (const Eigen::Vector3d& point : points) {
        const auto column = east->at(point.x());
        const auto from_south = north->at(point.y());
        if (!column || !from_south) {
            return std::nullopt;
        }
        double& height_m = grid.at({*column, frame.rows - 1 - *from_south});
        if (!std::isnan(height_m) && height_m != point.z()) {
            return std::nullopt;
        }
        height_m = point.z();
    }
    return grid;
}

}  // namespace coupling::grids
