#pragma once

#include <functional>
#include <string>

#include "config/grid/raster.hpp"
#include "coupling/results/report/labels.hpp"

namespace coupling::report {

/// A round step of heights, so that about a dozen contours lie between the lowest and the highest ground; 1 m
/// at least.
double contour_step_m(const config::Raster<double>& heights_m);

/// Contours of heights at the centres of cells: `d` of an SVG path. `on_sheet` takes easting and northing.
/// Squares with a missing height have none.
std::string contours(const config::Raster<double>& heights_m, double step_m,
                     const std::function<DrawnPoint(double, double)>& on_sheet);

}  // namespace coupling::report
