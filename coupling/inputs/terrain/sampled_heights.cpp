#include "coupling/inputs/terrain/sampled_heights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace coupling::plausible {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
/// Coordinates of a lattice are written to a few per cent of its spacing at least [choice].
constexpr double largest_offset = 0.02;
/// Nearer points are one [choice].
constexpr double smallest_spacing_m = 1e-3;
/// Most places of a lattice have neighbours; of points that were only rounded to whole metres few do
/// [choice].
constexpr double least_share_of_neighbours = 0.7;
constexpr double most_places_per_point = 20.0;

/// Equal steps along one axis.
struct Steps {
    double first_m = 0.0;
    double spacing_m = 0.0;
    int count = 0;

    [[nodiscard]] int at(double value_m) const {
        return static_cast<int>(std::lround((value_m - first_m) / spacing_m));
    }
};

/// The steps on which all values lie; nothing where they do not, or where there are more than `most`.
std::optional<Steps> steps_of(std::vector<double> values_m, double most) {
    std::sort(values_m.begin(), values_m.end());
    double smallest_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < values_m.size(); ++i) {
        const double gap_m = values_m[i] - values_m[i - 1];
        smallest_m = gap_m > smallest_spacing_m ? std::min(smallest_m, gap_m) : smallest_m;
    }
    const double extent_m = values_m.back() - values_m.front();
    const double steps = std::round(extent_m / smallest_m);
    if (!(steps >= 2.0) || steps > most) {
        return std::nullopt;
    }
    const Steps found{values_m.front(), extent_m / steps, static_cast<int>(steps) + 1};
    const bool all_lie_on_it = std::all_of(values_m.begin(), values_m.end(), [&](double value_m) {
        const double away = (value_m - found.first_m) / found.spacing_m;
        return std::abs(away - std::round(away)) <= largest_offset;
    });
    return all_lie_on_it ? std::optional{found} : std::nullopt;
}

bool has_neighbours(const config::Raster<double>& cells) {
    std::size_t known = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
        if (std::isnan(cells.values[i])) {
            continue;
        }
        ++known;
        const config::Cell cell = cells.frame.cell_of(i);
        for (const config::Cell next :
             {config::Cell{cell.column + 1, cell.row}, config::Cell{cell.column, cell.row + 1}}) {
            pairs += cells.frame.contains(next) && !std::isnan(cells.at(next)) ? 1 : 0;
        }
    }
    return static_cast<double>(pairs) >= 2.0 * least_share_of_neighbours * static_cast<double>(known);
}

std::optional<config::Raster<double>> lattice_of(const std::vector<Eigen::Vector3d>& points) {
    std::vector<double> easts_m;
    std::vector<double> norths_m;
    for (const Eigen::Vector3d& point : points) {
        easts_m.push_back(point.x());
        norths_m.push_back(point.y());
    }
    const double most = most_places_per_point * static_cast<double>(points.size());
    const auto columns = steps_of(std::move(easts_m), most);
    const auto rows = columns ? steps_of(std::move(norths_m), most / columns->count) : std::nullopt;
    if (!rows) {
        return std::nullopt;
    }
    config::GridFrame frame;
    frame.columns = columns->count;
    frame.rows = rows->count;
    frame.x_west_m = columns->first_m - 0.5 * columns->spacing_m;
    frame.y_south_m = rows->first_m - 0.5 * rows->spacing_m;
    frame.cell_width_m = columns->spacing_m;
    frame.cell_height_m = rows->spacing_m;
    config::Raster<double> cells{frame, not_known};
    for (const Eigen::Vector3d& point : points) {
        double& height_m = cells.at({columns->at(point.x()), rows->count - 1 - rows->at(point.y())});
        height_m = std::fmin(height_m, point.z());  // of two points in one place the lower, in any order
    }
    return has_neighbours(cells) ? std::optional{std::move(cells)} : std::nullopt;
}

/// Cells that lie within the extent of the points, about its middle.
config::GridFrame frame_about_the_middle(const std::vector<Eigen::Vector3d>& points) {
    constexpr double slack = 1e-9;  // an extent of whole cells keeps the last one
    Eigen::Vector2d low = points.front().head<2>();
    Eigen::Vector2d high = low;
    for (const Eigen::Vector3d& point : points) {
        low = low.cwiseMin(point.head<2>());
        high = high.cwiseMax(point.head<2>());
    }
    config::GridFrame frame = frame_over(points, 0.0);
    frame.columns = std::max(1, static_cast<int>((high.x() - low.x()) / frame.cell_width_m + slack));
    frame.rows = std::max(1, static_cast<int>((high.y() - low.y()) / frame.cell_height_m + slack));
    frame.x_west_m = 0.5 * (low.x() + high.x() - frame.columns * frame.cell_width_m);
    frame.y_south_m = 0.5 * (low.y() + high.y() - frame.rows * frame.cell_height_m);
    return frame;
}

}  // namespace

config::Raster<double> sampled_heights(const HeightInput& heights, const rockfall::Terrain& terrain) {
    if (std::optional<config::Raster<double>> lattice = lattice_of(heights.points)) {
        return *std::move(lattice);
    }
    HeightInput cells;
    cells.map_frame = frame_about_the_middle(heights.points);
    return heights_on_map(cells, terrain);
}

}  // namespace coupling::plausible
