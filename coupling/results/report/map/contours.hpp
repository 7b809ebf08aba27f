#pragma once

#include <array>
#include <functional>
#include <string>

#include "config/grid/raster.hpp"
#include "coupling/results/report/map/labels.hpp"

namespace coupling::report {

/// A round step of heights, so that about a dozen contours lie between the lowest and the highest ground; 1 m
/// at least.
double contour_step_m(double lowest_m, double highest_m);
double contour_step_m(const config::Raster<double>& heights_m);

/// Contours of heights at the centres of cells: `d` of an SVG path. `on_sheet` takes easting and northing.
/// Squares with a missing height have none, nor have those of which no corner is drawn: `is_drawn` takes
/// their four corners on the sheet; without it all are.
std::string contours(const config::Raster<double>& heights_m, double step_m,
                     const std::function<DrawnPoint(double, double)>& on_sheet,
                     const std::function<bool(const std::array<DrawnPoint, 4>&)>& is_drawn = {});

}  // namespace coupling::report
