#include "coupling/inputs/terrain/terrain_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "config/units/angle.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/grids/filled_holes.hpp"
#include "coupling/inputs/plausible/heights.hpp"
#include "coupling/inputs/plausible/repeated_points.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/map_size.hpp"
#include "coupling/inputs/scenario/output_settings.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "coupling/inputs/systems/coordinate_systems.hpp"
#include "coupling/inputs/systems/extent.hpp"
#include "coupling/inputs/tables/point_file.hpp"
#include "coupling/inputs/terrain/ground_share.hpp"
#include "coupling/inputs/terrain/known_degrees.hpp"
#include "coupling/inputs/terrain/mesh_input.hpp"
#include "rockfall/terrain/contact_zone.hpp"
#include "rockfall/terrain/mesh.hpp"

namespace coupling {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Throws InputError where no terrain can be made of the heights.
void check_grid(const config::Raster<double>& grid, const std::string& file, Reading& reading) {
    const config::GridFrame& frame = grid.frame;
    if (std::min(frame.cell_width_m, frame.cell_height_m) < 0.05) {
        config::fail(config::ExitCode::data, {file}, "cells of " + config::to_text(frame.cell_width_m),
                     "metres of a projected coordinate system, not degrees",
                     "transform the grid to the projected system of the other files");
    }
    const auto known = static_cast<std::size_t>(std::count_if(
        grid.values.begin(), grid.values.end(), [](double height_m) { return !std::isnan(height_m); }));
    if (frame.columns < 3 || frame.rows < 3 || known < 9) {
        config::fail(config::ExitCode::data, {file},
                     counted(known, "known height") + " in " + to_string(frame),
                     "at least 3 x 3 known cells");
    }
    plausible::check_grid_heights(grid, file, reading);
}

/// Heights that are said to be no metres become a problem. `file` says it.
void check_height_unit(const std::optional<formats::HeightUnit>& unit, const std::string& file,
                       Reading& reading) {
    const auto wrong = unit ? plausible::contradiction_of_heights(*unit) : std::nullopt;
    if (wrong) {
        reading.refuse({file}, wrong->found, wrong->expected, wrong->advice);
    }
}

/// A projection that contradicts the coordinates of the heights becomes a problem. `file` says it.
void check_projection(const std::string& text, const std::string& file, const plausible::Extent& extent,
                      Reading& reading) {
    check_height_unit(plausible::height_unit_in(text), file, reading);
    if (const auto wrong = plausible::contradiction_of(text, extent, file)) {
        reading.refuse({file}, wrong->found, wrong->expected, wrong->advice);
        return;
    }
    if (const auto scale = plausible::contradiction_of_scale(text, file, extent)) {
        const plausible::Contradiction& what = scale->contradiction;
        if (scale->is_refused) {
            reading.refuse({file}, what.found, what.expected, what.advice);
        } else {
            reading.warn({file}, what.found, what.expected, what.advice);
        }
    }
}

/// The text of the .prj file beside the heights, "" without one. A projection that contradicts their
/// coordinates becomes a problem.
std::string projection_beside(const std::string& name, const plausible::Extent& extent, Reading& reading) {
    const std::string beside_name = reading.name_beside(name, ".prj");
    const std::string beside = reading.shown(beside_name);
    std::string text = reading.text_beside("projection", beside_name);
    check_projection(text, beside, extent, reading);
    reading.take_system("terrain", beside_name, text);
    return text;
}

/// Small holes of laser scans cost rocks that nothing stops there.
void fill_small_holes(HeightInput& input, Reading& reading) {
    const grids::FilledHoles filled = grids::fill_holes(*input.grid, reading.terrain().fill_holes_m2);
    if (filled.holes > 0) {
        reading.note(input.file + ": " + counted(filled.holes, "hole") + " of NODATA, together " +
                     counted(filled.cells.size(), "cell") +
                     ", filled from the heights around, the first in " +
                     cell_in_words(input.grid->frame, filled.cells.front()) + " (terrain.fill_holes_m2)");
    }
    input.filled_cells = filled.cells;
}

double highest_m(const config::Raster<double>& grid) {
    return plausible::terrain::values_of(plausible::terrain::field_of(grid)).high_m;
}

/// The frame of the maps over a grid of heights.
void take_map_frame(const config::GridFrame& heights, HeightInput& input, const Reading& reading) {
    const double cell_size_m = reading.output().cell_size_m;
    if (cell_size_m > 0.0) {
        check_map_size(heights, cell_size_m, reading.scenario());
    }
    input.map_frame = with_cell_size(heights, cell_size_m);
}

HeightInput read_dem(Reading& reading) {
    HeightInput input;
    const std::string& dem = reading.terrain().dem;
    input.file = shown_tables(dem, reading);
    input.grid = reading.grid("terrain.dem", "dem", dem);
    check_grid(*input.grid, input.file, reading);
    input.projection = reading.system_of("dem");
    const bool is_beside = reading.has_input("projection");
    const std::string beside = is_beside ? reading.shown(reading.name_beside(dem, ".prj")) : input.file;
    check_projection(input.projection, beside, plausible::extent_of(input.grid->frame), reading);
    plausible::check_highest_of_system(highest_m(*input.grid), input.projection, input.file);
    if (input.projection.empty()) {
        const bool is_file = list_of_files(dem).size() == 1 && !is_folder(reading.settings().resolve(dem));
        const std::string missing = is_file ? reading.shown(reading.name_beside(dem, ".prj")) : ".prj";
        reading.note(input.file + ": no " + missing + " beside it, so the results name no projection");
    }
    fill_small_holes(input, reading);
    take_map_frame(input.grid->frame, input, reading);
    return input;
}

/// Heights of a plane at the centres of patches.
HeightInput plane_heights(Reading& reading) {
    const PlaneGround& plane = reading.terrain().plane;
    const double cell_m = 10.0;
    HeightInput input;
    input.file = "terrain.plane";
    const config::GridFrame frame{.columns = static_cast<int>(std::lround(plane.width_m / cell_m)),
                                  .rows = static_cast<int>(std::lround(plane.length_m / cell_m)),
                                  .cell_width_m = cell_m,
                                  .cell_height_m = cell_m};
    const double fall = std::tan(config::Angle::from_degrees(plane.slope_deg).in_radians());
    const double aspect_rad = config::Angle::from_degrees(plane.aspect_deg).in_radians();
    input.grid = config::Raster<double>{frame};
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const double east_m = frame.x_centre_m(cell.column) - 0.5 * plane.width_m;
        const double north_m = frame.y_centre_m(cell.row) - 0.5 * plane.length_m;
        input.grid->values[i] =
            plane.elevation_m - fall * (east_m * std::sin(aspect_rad) + north_m * std::cos(aspect_rad));
    }
    take_map_frame(frame, input, reading);
    return input;
}

/// One cell over all points.
config::GridFrame extent_over(const std::vector<Eigen::Vector3d>& points) {
    Eigen::Vector2d low = points.front().head<2>();
    Eigen::Vector2d high = low;
    for (const Eigen::Vector3d& point : points) {
        low = low.cwiseMin(point.head<2>());
        high = high.cwiseMax(point.head<2>());
    }
    const Eigen::Vector2d extent = (high - low).cwiseMax(1e-3);
    return {.columns = 1,
            .rows = 1,
            .x_west_m = low.x(),
            .y_south_m = low.y(),
            .cell_width_m = extent.x(),
            .cell_height_m = extent.y()};
}

/// The frame of the maps over points, refused where their coordinates or the cells cannot be meant.
config::GridFrame checked_frame_over(const std::vector<Eigen::Vector3d>& points,
                                     const std::string& projection, const std::string& file,
                                     Reading& reading) {
    const config::GridFrame extent = extent_over(points);
    check_extent(extent.cell_width_m, extent.cell_height_m, file);
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [](const auto& a, const auto& b) { return a.z() < b.z(); });
    plausible::check_height_range(low->z(), high->z(), file);
    plausible::check_highest_of_system(high->z(), projection, file);
    const double cell_size_m = reading.output().cell_size_m;
    if (cell_size_m > 0.0) {
        check_map_size(extent, cell_size_m, reading.scenario());
    }
    return frame_over(points, cell_size_m);
}

HeightInput read_point_cloud(Reading& reading) {
    HeightInput input;
    input.file = reading.shown(reading.terrain().points);
    const FileBytes bytes =
        reading.open("terrain.points", "points", reading.terrain().points, "a text of x y z");
    formats::refuse_what_is_no_text_of_points(bytes.text(), input.file);
    tables::PointFile read = tables::read_point_file(bytes.text(), input.file);
    input.points = std::move(read.points);
    for (std::string& sentence : read.notes) {
        reading.note(std::move(sentence));
    }
    if (input.points.size() < 3) {
        config::fail(config::ExitCode::data, {input.file}, counted(input.points.size(), "point"),
                     "at least three");
    }
    plausible::judge_repeated_points(input.points, input.file, reading);
    input.projection =
        projection_beside(reading.terrain().points, plausible::extent_of(extent_over(input.points)), reading);
    input.map_frame = checked_frame_over(input.points, input.projection, input.file, reading);
    return input;
}

HeightInput read_given_mesh(Reading& reading) {
    HeightInput input;
    const std::string& name =
        reading.terrain().mesh.empty() ? reading.terrain().meshes : reading.terrain().mesh;
    input.file = reading.shown(name);
    meshes::MeshInput mesh = meshes::read_mesh(reading);
    input.has_codes = mesh.has_codes;
    input.mesh_parts = std::move(mesh.parts);
    input.left_out = std::move(mesh.left_out);
    if (mesh.tin) {
        input.points = std::move(mesh.tin->vertices_m);
        input.faces = std::move(mesh.tin->faces);
        for (const char* key : {"rockfall.vertical_tolerance_m", "terrain.longest_edge_m"}) {
            if (reading.settings().options->was_set(key)) {
                reading.note(std::string{key} + " has no effect: the faces of terrain.mesh stay as they are");
            }
        }
    } else {
        input.points = std::move(mesh.points_m);
        input.lines = std::move(mesh.lines);
    }
    input.projection =
        projection_beside(mesh.first_file, plausible::extent_of(extent_over(input.points)), reading);
    input.map_frame = checked_frame_over(input.points, input.projection, input.file, reading);
    return input;
}

/// Straight between the four cell centres around a point; where one is missing, the value of its own cell.
double height_at(const config::Raster<double>& grid, double x_m, double y_m) {
    const config::GridFrame& frame = grid.frame;
    const double column = (x_m - frame.x_west_m) / frame.cell_width_m - 0.5;
    const double row = (frame.y_north_m() - y_m) / frame.cell_height_m - 0.5;
    const config::Cell corner{static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row))};
    if (frame.contains(corner) && frame.contains({corner.column + 1, corner.row + 1})) {
        const double east = column - corner.column;
        const double south = row - corner.row;
        const double upper = (1.0 - east) * grid.at(corner) + east * grid.at({corner.column + 1, corner.row});
        const double lower = (1.0 - east) * grid.at({corner.column, corner.row + 1}) +
                             east * grid.at({corner.column + 1, corner.row + 1});
        const double height_m = (1.0 - south) * upper + south * lower;
        if (!std::isnan(height_m)) {
            return height_m;
        }
    }
    const config::Cell own = frame.cell_at(x_m, y_m);
    return frame.contains(own) ? grid.at(own) : not_a_number;
}

}  // namespace

std::optional<HeightInput> read_heights(Reading& reading) {
    return reading.attempt([&] {
        HeightInput input = reading.terrain().plane.is_given() ? plane_heights(reading)
                            : !reading.terrain().dem.empty()   ? read_dem(reading)
                            : reading.terrain().has_mesh()     ? read_given_mesh(reading)
                                                               : read_point_cloud(reading);
        check_degrees(input.projection, input.map_frame, input.file, reading);
        input.noise = input.grid ? rockfall::HeightNoise{*input.grid} : rockfall::HeightNoise{input.points};
        return input;
    });
}

std::vector<Eigen::Vector3d> read_points(std::string_view text, const std::string& file) {
    return tables::read_point_file(text, file).points;
}

config::GridFrame with_cell_size(const config::GridFrame& frame, double cell_size_m) {
    if (!(cell_size_m > 0.0)) {
        return frame;
    }
    constexpr double slack = 1e-9;  // an extent of whole cells gets no further row by rounding
    const double width_m = frame.x_east_m() - frame.x_west_m;
    const double height_m = frame.y_north_m() - frame.y_south_m;
    config::GridFrame map = frame;
    map.cell_width_m = cell_size_m;
    map.cell_height_m = cell_size_m;
    map.columns = std::max(1, static_cast<int>(std::ceil(width_m / cell_size_m - slack)));
    map.rows = std::max(1, static_cast<int>(std::ceil(height_m / cell_size_m - slack)));
    return map;
}

config::GridFrame frame_over(const std::vector<Eigen::Vector3d>& points, double cell_size_m) {
    const config::GridFrame whole = extent_over(points);
    if (!(cell_size_m > 0.0)) {
        const double spacing_m =
            std::sqrt(whole.cell_width_m * whole.cell_height_m / static_cast<double>(points.size()));
        const double power = std::pow(10.0, std::floor(std::log10(spacing_m)));
        const double ratio = spacing_m / power;
        cell_size_m = power * (ratio <= 1.0 ? 1.0 : ratio <= 2.0 ? 2.0 : ratio <= 5.0 ? 5.0 : 10.0);
    }
    return with_cell_size(whole, cell_size_m);
}

namespace {

rockfall::Terrain triangulated(const HeightInput& input, const rockfall::GroundLaw& law,
                               double mean_diameter_m, double longest_edge_m) {
    const rockfall::ContactLaw contact = law.contact_law(mean_diameter_m);
    if (input.grid) {
        return rockfall::triangulate(rockfall::contact_zone(*input.grid, contact, input.noise),
                                     law.vertical_tolerance_m);
    }
    std::vector<Eigen::Vector3d> felt = rockfall::contact_zone(input.points, contact, input.noise);
    if (!input.faces.empty()) {
        return rockfall::terrain_of({std::move(felt), input.faces});
    }
    return input.lines.empty() ? rockfall::triangulate(felt, longest_edge_m)
                               : rockfall::triangulate(felt, input.lines, longest_edge_m);
}

}  // namespace

rockfall::Terrain build_terrain(const HeightInput& input, const rockfall::GroundLaw& law,
                                double mean_diameter_m, double longest_edge_m, Reading& reading) {
    rockfall::Terrain terrain = triangulated(input, law, mean_diameter_m, longest_edge_m);
    if (!reading.terrain().plane.is_given()) {  // which may be level: somebody said so
        plausible::judge_ground(input, longest_edge_m, terrain, reading);
    }
    return terrain;
}

config::Raster<double> heights_on_map(const HeightInput& input, const rockfall::Terrain& terrain) {
    if (input.grid && input.grid->frame == input.map_frame) {
        return *input.grid;
    }
    config::Raster<double> heights{input.map_frame, not_a_number};
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const config::Cell cell = input.map_frame.cell_of(i);
        const double x_m = input.map_frame.x_centre_m(cell.column);
        const double y_m = input.map_frame.y_centre_m(cell.row);
        heights.values[i] = input.grid
                                ? height_at(*input.grid, x_m, y_m)
                                : terrain.height_m(x_m - terrain.origin_m().x(), y_m - terrain.origin_m().y())
                                      .value_or(not_a_number);
    }
    return heights;
}

bool has_ground(const HeightInput& input, const config::GridFrame& frame, const rockfall::Terrain& terrain,
                std::size_t cell) {
    if (input.grid) {
        return !std::isnan(input.grid->values[cell]);
    }
    const config::Cell place = frame.cell_of(cell);
    return terrain
        .locate(frame.x_centre_m(place.column) - terrain.origin_m().x(),
                frame.y_centre_m(place.row) - terrain.origin_m().y())
        .has_value();
}

}  // namespace coupling
