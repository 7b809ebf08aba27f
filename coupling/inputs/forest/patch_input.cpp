#include "coupling/inputs/forest/patch_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/text/joined.hpp"
#include "forest/light/direction.hpp"

namespace coupling {
namespace {

using config::joined;
using forest::patch_side_m;

constexpr double patch_not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double steepest_deg = 80.0;
constexpr int rim = 5;  // cells around the patches

/// Straight between the four nearest cell centres, or on from them; NaN where one of them is missing.
double height_between(const config::Raster<double>& heights_m, double x_m, double y_m) {
    const config::GridFrame& frame = heights_m.frame;
    const double column = (x_m - frame.x_west_m) / frame.cell_width_m - 0.5;
    const double row = (frame.y_north_m() - y_m) / frame.cell_height_m - 0.5;
    const int west = std::clamp(static_cast<int>(std::floor(column)), 0, frame.columns - 2);
    const int north = std::clamp(static_cast<int>(std::floor(row)), 0, frame.rows - 2);
    const double east_share = column - west;
    const double south_share = row - north;
    const auto between = [&](int at_row) {
        return (1.0 - east_share) * heights_m.at({west, at_row}) +
               east_share * heights_m.at({west + 1, at_row});
    };
    return (1.0 - south_share) * between(north) + south_share * between(north + 1);
}

struct Faults {
    std::size_t without_ground = 0;
    std::size_t too_steep = 0;
};

std::optional<forest::Patch> patch_of(const PatchCover& cover, const std::optional<GroundPlane>& plane,
                                      config::Cell cell, Faults& faults) {
    if (!plane) {
        ++faults.without_ground;
        return std::nullopt;
    }
    forest::Patch patch;
    patch.cell = cell;
    patch.ground_m = plane->height_m;
    patch.slope = forest::arc_cosine(forest::ground_normal_of_gradient(plane->rise_x, plane->rise_y).z);
    patch.aspect = forest::azimuth_of(-plane->rise_x, -plane->rise_y);
    patch.soil = cover.soil;
    patch.management_unit = cover.stand;
    if (patch.slope.in_degrees() >= steepest_deg) {
        ++faults.too_steep;
        return std::nullopt;
    }
    return patch;
}

/// The part of a frame with the patches, and their cells counted from its corner.
config::GridFrame cut_around(const config::GridFrame& frame, std::vector<forest::Patch>& patches) {
    config::Cell low{frame.columns - 1, frame.rows - 1};
    config::Cell high{0, 0};
    for (const forest::Patch& patch : patches) {
        low = {std::min(low.column, patch.cell.column), std::min(low.row, patch.cell.row)};
        high = {std::max(high.column, patch.cell.column), std::max(high.row, patch.cell.row)};
    }
    low = {std::max(0, low.column - rim), std::max(0, low.row - rim)};
    high = {std::min(frame.columns - 1, high.column + rim), std::min(frame.rows - 1, high.row + rim)};
    for (forest::Patch& patch : patches) {
        patch.cell = {patch.cell.column - low.column, patch.cell.row - low.row};
    }
    config::GridFrame part = frame;
    part.columns = high.column - low.column + 1;
    part.rows = high.row - low.row + 1;
    part.x_west_m = frame.x_west_m + low.column * patch_side_m;
    part.y_south_m = frame.y_south_m + (frame.rows - 1 - high.row) * patch_side_m;
    return part;
}

/// Gives cells without a height the mean of their neighbours, from the known ones outwards.
void fill(config::Raster<double>& raster) {
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        if (std::isnan(raster.values[i])) {
            unknown.push_back(i);
        }
    }
    while (!unknown.empty()) {
        std::vector<std::size_t> still;
        std::vector<std::pair<std::size_t, double>> found;
        for (const std::size_t i : unknown) {
            const config::Cell cell = raster.frame.cell_of(i);
            double sum = 0.0;
            int count = 0;
            for (const config::Cell step : {config::Cell{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const config::Cell there{cell.column + step.column, cell.row + step.row};
                if (raster.frame.contains(there) && !std::isnan(raster.at(there))) {
                    sum += raster.at(there);
                    ++count;
                }
            }
            if (count > 0) {
                found.emplace_back(i, sum / count);
            } else {
                still.push_back(i);
            }
        }
        for (const auto& [i, height_m] : found) {
            raster.values[i] = height_m;
        }
        unknown = std::move(still);
    }
}

void warn_of(const Faults& faults, const std::string& file, Reading& reading) {
    if (faults.without_ground > 0) {
        reading.note(joined(file, ": ", counted(faults.without_ground, "forest cell"),
                            " of 10 m without ground everywhere; left out"));
    }
    if (faults.too_steep > 0) {
        reading.note(joined(file, ": ", counted(faults.too_steep, "forest cell"),
                            " of 10 m steeper than 80 degrees; left out"));
    }
}

}  // namespace

std::optional<GroundPlane> mean_plane(const config::Raster<double>& heights_m, double x_m, double y_m,
                                      double side_m) {
    const double cell_m = std::min(heights_m.frame.cell_width_m, heights_m.frame.cell_height_m);
    const int points = std::clamp(static_cast<int>(std::ceil(side_m / cell_m)), 3, 20);
    const double step_m = side_m / points;
    GroundPlane sums;
    double squares_m2 = 0.0;
    for (int i = 0; i < points; ++i) {
        const double east_m = (i + 0.5) * step_m - 0.5 * side_m;
        squares_m2 += points * east_m * east_m;
        for (int j = 0; j < points; ++j) {
            const double north_m = (j + 0.5) * step_m - 0.5 * side_m;
            const double height_m = height_between(heights_m, x_m + east_m, y_m + north_m);
            sums.height_m += height_m;
            sums.rise_x += height_m * east_m;
            sums.rise_y += height_m * north_m;
        }
    }
    if (std::isnan(sums.height_m)) {
        return std::nullopt;
    }
    return GroundPlane{sums.height_m / (points * points), sums.rise_x / squares_m2, sums.rise_y / squares_m2};
}

config::GridFrame patch_frame(const config::GridFrame& heights) {
    constexpr double slack = 1e-6;  // a border that lies on a multiple but for rounding
    const double west = std::ceil(heights.x_west_m / patch_side_m - slack);
    const double south = std::ceil(heights.y_south_m / patch_side_m - slack);
    const double east = std::floor(heights.x_east_m() / patch_side_m + slack);
    const double north = std::floor(heights.y_north_m() / patch_side_m + slack);
    return {.columns = static_cast<int>(std::max(0.0, east - west)),
            .rows = static_cast<int>(std::max(0.0, north - south)),
            .x_west_m = west * patch_side_m,
            .y_south_m = south * patch_side_m,
            .cell_width_m = patch_side_m,
            .cell_height_m = patch_side_m};
}

ForestGround make_ground(const config::Raster<double>& heights_m, const std::string& file,
                         const std::string& stands_file,
                         const std::function<std::optional<PatchCover>(double x_m, double y_m)>& cover_at,
                         Reading& reading) {
    if (std::min(heights_m.frame.columns, heights_m.frame.rows) < 2) {
        config::fail(config::ExitCode::data, {file}, to_string(heights_m.frame),
                     "at least 2 x 2 cells for a forest");
    }
    const config::GridFrame whole = patch_frame(heights_m.frame);
    std::vector<forest::Patch> patches;
    Faults faults;
    bool any_stand = false;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const config::Cell cell = whole.cell_of(i);
        const double x_m = whole.x_centre_m(cell.column);
        const double y_m = whole.y_centre_m(cell.row);
        if (const auto cover = cover_at(x_m, y_m)) {
            any_stand = true;
            if (auto patch = patch_of(*cover, mean_plane(heights_m, x_m, y_m, patch_side_m), cell, faults)) {
                patches.push_back(*patch);
            }
        }
    }
    warn_of(faults, file, reading);
    if (!any_stand) {
        config::fail(config::ExitCode::data, {stands_file},
                     joined("no stand on the ground of ", file, ", ", to_string(heights_m.frame)),
                     "stands there: a map of the same slope in the same coordinate system");
    }
    if (patches.empty()) {
        config::fail(config::ExitCode::data, {file}, "no forest cell of 10 m with ground", "at least one");
    }
    const config::GridFrame frame = cut_around(whole, patches);
    config::Raster<double> elevation_m{frame, patch_not_a_number};
    std::vector<forest::Horizon> horizons(frame.size());
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const auto plane =
            mean_plane(heights_m, frame.x_centre_m(cell.column), frame.y_centre_m(cell.row), patch_side_m);
        elevation_m.values[i] = plane ? plane->height_m : patch_not_a_number;
    }
    fill(elevation_m);
    for (const forest::Patch& patch : patches) {
        horizons[frame.index(patch.cell)] = forest::horizon_at(heights_m, frame.x_centre_m(patch.cell.column),
                                                               frame.y_centre_m(patch.cell.row));
    }
    return {forest::PatchGrid{frame, std::move(patches)}, std::move(elevation_m), std::move(horizons)};
}

}  // namespace coupling
