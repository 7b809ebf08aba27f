#include "coupling/results/report/map/contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "coupling/results/report/map/outlines.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::report {
namespace {

/// The part of one contour inside a square of four heights: it enters through one side and leaves through
/// another; a saddle has two such parts, and either way to join them is right.
void add_level(PathText& path, const std::array<double, 4>& heights_m,
               const std::array<DrawnPoint, 4>& corners, double level_m) {
    std::array<DrawnPoint, 4> crossings{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        if ((heights_m[i] < level_m) != (heights_m[j] < level_m)) {
            const double part = (level_m - heights_m[i]) / (heights_m[j] - heights_m[i]);
            crossings[count++] = {std::lerp(corners[i].x, corners[j].x, part),
                                  std::lerp(corners[i].y, corners[j].y, part)};
        }
    }
    for (std::size_t i = 0; i + 1 < count; i += 2) {
        path.line(crossings[i].x, crossings[i].y, crossings[i + 1].x, crossings[i + 1].y);
    }
}

}  // namespace

double contour_step_m(double lowest_m, double highest_m) {
    return highest_m > lowest_m ? nice_step(std::max(1.0, (highest_m - lowest_m) / 14.0)) : 1.0;
}

double contour_step_m(const config::Raster<double>& heights_m) {
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -low_m;
    for (const double height_m : heights_m.values) {
        if (!std::isnan(height_m)) {
            low_m = std::min(low_m, height_m);
            high_m = std::max(high_m, height_m);
        }
    }
    return contour_step_m(low_m, high_m);
}

std::string contours(const config::Raster<double>& heights_m, double step_m,
                     const std::function<DrawnPoint(double, double)>& on_sheet,
                     const std::function<bool(const std::array<DrawnPoint, 4>&)>& is_drawn) {
    const config::GridFrame& frame = heights_m.frame;
    PathText path;
    for (std::size_t i = 0; i < heights_m.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        const std::array<config::Cell, 4> around{
            cell, {cell.column + 1, cell.row}, {cell.column + 1, cell.row + 1}, {cell.column, cell.row + 1}};
        if (!frame.contains(around[2])) {
            continue;
        }
        std::array<double, 4> corner_m{};
        std::array<DrawnPoint, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) {
            corner_m[k] = heights_m.at(around[k]);
            corners[k] = on_sheet(frame.x_centre_m(around[k].column), frame.y_centre_m(around[k].row));
        }
        if ((is_drawn && !is_drawn(corners)) ||
            std::any_of(corner_m.begin(), corner_m.end(), [](double h) { return std::isnan(h); })) {
            continue;
        }
        const auto [low, high] = std::minmax_element(corner_m.begin(), corner_m.end());
        for (double level_m = std::ceil(*low / step_m) * step_m; level_m <= *high; level_m += step_m) {
            add_level(path, corner_m, corners, level_m);
        }
    }
    return path.text();
}

}  // namespace coupling::report
