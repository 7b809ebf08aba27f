#include "coupling/program/actions/given_heights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/file_kinds.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/grids/grid_file.hpp"
#include "coupling/inputs/grids/tiles.hpp"
#include "coupling/inputs/grids/xyz_grid.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/tables/point_file.hpp"
#include "coupling/inputs/tables/words.hpp"
#include "coupling/inputs/terrain/terrain_input.hpp"
#include "coupling/program/actions/given_files.hpp"

namespace coupling {
namespace {

using config::joined;

void remark(GivenHeights& heights, std::string sentence) {
    heights.remarks.push_back(std::move(sentence));
}

std::string system_in_words(const std::string& system) {
    return system.empty() ? "no coordinate system" : plausible::name_of_system(system);
}

template <class Heights>
std::optional<double> mean_of(const Heights& heights) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const double height_m : heights) {
        sum += std::isnan(height_m) ? 0.0 : height_m;
        count += std::isnan(height_m) ? 0 : 1;
    }
    return count > 0 ? std::optional{sum / static_cast<double>(count)} : std::nullopt;
}

/// Mean heights of points in cells of twice their spacing, wider where these were more than a million
/// [choice]; unknown where no point lies.
config::Raster<double> coarse_cells(const std::vector<Eigen::Vector3d>& points,
                                    const plausible::Extent& extent, double spacing_m) {
    constexpr double most_cells = 1e6;
    constexpr double least_m = 1e-3;
    const double east_m = extent.east_m - extent.west_m;
    const double north_m = extent.north_m - extent.south_m;
    const double cell_m = std::max({2.0 * spacing_m, std::sqrt(east_m * north_m / most_cells), least_m});
    config::GridFrame frame;
    frame.x_west_m = extent.west_m;
    frame.y_south_m = extent.south_m;
    frame.cell_width_m = cell_m;
    frame.cell_height_m = cell_m;
    frame.columns = std::max(1, static_cast<int>(std::ceil(east_m / cell_m)));
    frame.rows = std::max(1, static_cast<int>(std::ceil(north_m / cell_m)));
    config::Raster<double> sums{frame, 0.0};
    std::vector<int> counts(frame.size(), 0);
    for (const Eigen::Vector3d& point : points) {
        const int column = static_cast<int>((point.x() - frame.x_west_m) / cell_m);
        const int row = static_cast<int>((frame.y_north_m() - point.y()) / cell_m);
        const std::size_t cell =
            frame.index({std::clamp(column, 0, frame.columns - 1), std::clamp(row, 0, frame.rows - 1)});
        sums.values[cell] += point.z();
        ++counts[cell];
    }
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        sums.values[cell] =
            counts[cell] > 0 ? sums.values[cell] / counts[cell] : std::numeric_limits<double>::quiet_NaN();
    }
    return sums;
}

/// A mesh, a drawing of contours or points in no rows and columns: the terrain is made of them. Nothing for
/// what is a grid or tiles.
std::optional<GivenHeights> without_cells(const std::vector<std::string>& dem) {
    if (dem.size() != 1 || is_folder(formats::split_layer_name(dem.front()).file)) {
        return std::nullopt;
    }
    GivenFile file{dem.front()};
    const bool is_mesh = formats::mesh_kind(file.bytes(), file.name()) != nullptr;
    const bool is_points = !file.is_grid() && !is_mesh && !formats::is_gis_layer(file.bytes()) &&
                           formats::is_list_of_points(file.bytes());
    std::vector<Eigen::Vector3d> points;
    if (is_points) {
        points = tables::read_point_file(file.bytes(), file.name()).points;
        if (grids::grid_of_points(points)) {
            return std::nullopt;
        }
    } else if (is_mesh) {
        points = meshes::read_mesh_file(file.bytes(), file.name()).points_m;
    } else {
        return std::nullopt;
    }
    GivenHeights heights;
    heights.setting = is_points ? "points" : "mesh";
    heights.system = file.system_beside();
    if (points.size() >= 3) {
        const config::GridFrame frame = frame_over(points, 0.0);
        heights.spacing_m = std::max(frame.cell_width_m, frame.cell_height_m);
        heights.extent = plausible::extent_of(frame);
        heights.raster = coarse_cells(points, *heights.extent, heights.spacing_m);
    }
    std::vector<double> heights_m;
    for (const Eigen::Vector3d& point : points) {
        heights_m.push_back(point.z());
    }
    heights.mean_height_m = mean_of(heights_m);
    remark(heights, joined(file.name(), ": ground heights, ", is_mesh ? "a mesh or contours of " : "",
                           counted(points.size(), "point"), ", ",
                           heights.system.empty() ? "no coordinate system beside it"
                                                  : system_in_words(heights.system)));
    return heights;
}

}  // namespace

GivenHeights given_heights(const std::vector<std::string>& dem) {
    if (auto heights = without_cells(dem)) {
        return std::move(*heights);
    }
    HeightFiles files;
    grids::ReadGrid read = grids::read_grid(dem, {}, grids::GridValues::heights, std::nullopt, files.files());
    GivenHeights heights;
    heights.setting = "dem";
    if (!read.is_mosaic) {
        heights.remarks = std::move(read.notes);
    }
    heights.system = std::move(read.projection);
    heights.raster = std::move(read.raster);
    heights.has_grid = true;
    const config::GridFrame& frame = heights.raster.frame;
    heights.spacing_m = std::max(frame.cell_width_m, frame.cell_height_m);
    heights.extent = plausible::extent_of(frame);
    heights.mean_height_m = mean_of(heights.raster.values);
    plausible::refuse_wrong_heights(heights.raster, heights.system, dem.front());
    remark(heights, joined(listed(dem), ": ground heights, ", read.is_mosaic ? "tiles of together " : "",
                           to_string(frame), ", ", system_in_words(heights.system)));
    return heights;
}

}  // namespace coupling
