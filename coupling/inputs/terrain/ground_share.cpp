#include "coupling/inputs/terrain/ground_share.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "config/grid/holes.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/plausible/outline.hpp"
#include "coupling/inputs/plausible/share_on_terrain.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

/// A hundredth of the area is lost at single gaps of a survey too [choice].
constexpr double hardly_any = 0.01;
/// From here the maps show holes rather than a slope [choice]: cells of which a fifth is unknown here and
/// there leave four tenths of their area without a triangle.
constexpr double most_without_ground = 0.4;
/// From here the rocks that are lost are no detail any more [choice].
constexpr double much_without_ground = 0.1;
/// Less is no slope, but the noise of a level plane [choice].
constexpr double least_relief_m = 0.1;

constexpr const char* fill_gaps =
    "fill the gaps (QGIS: Fill NoData cells; gdal_fillnodata), or make the grid with larger cells";

config::Raster<double> known_cells(const HeightInput& heights) {
    if (heights.grid) {
        return *heights.grid;
    }
    config::Raster<double> cells{frame_over(heights.points, 0.0), std::numeric_limits<double>::quiet_NaN()};
    for (const Eigen::Vector3d& point : heights.points) {
        config::Cell cell = cells.frame.cell_at(point.x(), point.y());
        cell.column = std::clamp(cell.column, 0, cells.frame.columns - 1);
        cell.row = std::clamp(cell.row, 0, cells.frame.rows - 1);
        cells.at(cell) = point.z();
    }
    return cells;
}

double plan_area_m2(const rockfall::Terrain& terrain) {
    double sum_m2 = 0.0;
    for (const rockfall::Triangle& triangle : terrain.triangles()) {
        const rockfall::Vertex& a = terrain.vertices()[triangle.corners[0]];
        const rockfall::Vertex& b = terrain.vertices()[triangle.corners[1]];
        const rockfall::Vertex& c = terrain.vertices()[triangle.corners[2]];
        sum_m2 += 0.5 * ((b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m));
    }
    return sum_m2;
}

/// Lowest and highest of the heights that are known.
std::pair<double, double> height_range(const HeightInput& heights) {
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -low_m;
    const auto take = [&](double height_m) {
        if (!std::isnan(height_m)) {
            low_m = std::min(low_m, height_m);
            high_m = std::max(high_m, height_m);
        }
    };
    if (heights.grid) {
        std::for_each(heights.grid->values.begin(), heights.grid->values.end(), take);
    } else {
        for (const Eigen::Vector3d& point : heights.points) {
            take(point.z());
        }
    }
    return {low_m, high_m};
}

/// Whether points lie on one line, to a millionth of its length.
bool are_on_one_line(const std::vector<Eigen::Vector3d>& points) {
    const auto farthest_from = [&](const Eigen::Vector2d& place) {
        return std::max_element(points.begin(), points.end(),
                                [&](const auto& a, const auto& b) {
                                    return (a.template head<2>() - place).squaredNorm() <
                                           (b.template head<2>() - place).squaredNorm();
                                })
            ->template head<2>();
    };
    const Eigen::Vector2d one = farthest_from(points.front().head<2>());
    const Eigen::Vector2d way = Eigen::Vector2d{farthest_from(one)} - one;
    return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& point) {
        const Eigen::Vector2d to = point.head<2>() - one;
        return std::abs(way.x() * to.y() - way.y() * to.x()) <= 1e-6 * way.squaredNorm();
    });
}

/// Whether what is unknown inside the outline lies mostly in holes that known cells enclose: their place can
/// be named.
bool are_holes(const config::Raster<double>& grid, const GroundShare& share) {
    std::size_t cells = 0;
    for (const config::Hole& hole : config::holes_of(grid)) {
        cells += hole.cells;
    }
    return cells > 0 && 2 * cells >= share.unknown_cells;
}

std::string metres(double value_m) {
    return config::to_text(std::round(100.0 * value_m) / 100.0);
}

}  // namespace

GroundShare ground_share(const HeightInput& heights, const rockfall::Terrain& terrain) {
    const config::Raster<double> cells = known_cells(heights);
    const Outline outline = outline_of(cells);
    if (!(outline.area_m2 > 0.0)) {
        return {};
    }
    return {std::clamp(1.0 - plan_area_m2(terrain) / outline.area_m2, 0.0, 1.0), outline.unknown,
            outline.unknown_cells};
}

void refuse_terrain_without_faces(const HeightInput& heights, double longest_edge_m,
                                  const rockfall::Terrain& terrain) {
    if (!terrain.triangles().empty()) {
        return;
    }
    const std::string found = "a terrain without a face: ";
    if (heights.grid) {
        const auto known =
            static_cast<std::size_t>(std::count_if(heights.grid->values.begin(), heights.grid->values.end(),
                                                   [](double height_m) { return !std::isnan(height_m); }));
        config::fail(config::ExitCode::data, {heights.file},
                     joined(found, "no three known cells lie side by side (", counted(known, "known cell"),
                            " of ", std::to_string(heights.grid->values.size()), ")"),
                     "known heights in neighbouring cells", fill_gaps);
    }
    if (are_on_one_line(heights.points)) {
        config::fail(config::ExitCode::data, {heights.file},
                     joined(found, "all ", std::to_string(heights.points.size()), " points lie on one line"),
                     "points spread over an area, such as several contours",
                     "add what lies beside the line, or name another file");
    }
    const config::GridFrame frame = frame_over(heights.points, 0.0);
    const double spacing_m = std::sqrt(frame.cell_width_m * frame.columns * frame.cell_height_m * frame.rows /
                                       static_cast<double>(heights.points.size()));
    config::fail(config::ExitCode::data, {heights.file},
                 joined(found, "terrain.longest_edge_m is ", config::to_text(longest_edge_m),
                        ", the points lie about ", metres(spacing_m), " m apart"),
                 "triangles with edges of at most terrain.longest_edge_m",
                 "set terrain.longest_edge_m to several times that distance, or to 0, which keeps all");
}

void refuse_terrain_without_relief(const HeightInput& heights) {
    const auto [low_m, high_m] = height_range(heights);
    if (!(high_m - low_m < least_relief_m)) {
        return;
    }
    config::fail(
        config::ExitCode::data, {heights.file},
        high_m > low_m ? joined("all heights between ", metres(low_m), " and ", metres(high_m), " m")
                       : joined("all heights ", metres(low_m), " m"),
        "a slope, not a level plane",
        heights.grid
            ? "name the grid that holds the heights of the ground"
            : "contours carry their heights in group 38 or in z (DXF), as a third coordinate "
              "(LINESTRING Z) or in a column height_m, points in their third column: these have none");
}

void judge_ground(const HeightInput& heights, double longest_edge_m, const rockfall::Terrain& terrain,
                  Reading& reading) {
    refuse_terrain_without_faces(heights, longest_edge_m, terrain);
    refuse_terrain_without_relief(heights);
    if (!heights.faces.empty()) {
        return;  // holes of a mesh are those that its author left
    }
    const GroundShare share = ground_share(heights, terrain);
    const config::Effect effect =
        share.without_ground > much_without_ground ? config::Effect::answer : config::Effect::part;
    if (share.without_ground <= most_without_ground && heights.grid && are_holes(*heights.grid, share)) {
        doubt_holes(*heights.grid, heights.file, effect, reading);
        return;
    }
    if (share.without_ground <= hardly_any) {
        return;
    }
    const std::string found =
        joined(percent_in_words(share.without_ground), " of the area inside the outline without ground");
    const std::string expected = "heights almost everywhere inside the outline";
    const std::string advice =
        heights.grid ? fill_gaps : "raise terrain.longest_edge_m, or set it to 0, which keeps all triangles";
    const std::string cells = joined(percent_in_words(share.unknown), " of its cells are unknown");
    if (share.without_ground > most_without_ground) {
        reading.refuse({heights.file}, heights.grid ? joined(found, ": ", cells) : found, expected, advice);
        return;
    }
    reading.warn({heights.file}, joined(found, "; rocks that come there leave the terrain"), expected, advice,
                 effect);
}

}  // namespace coupling::plausible
