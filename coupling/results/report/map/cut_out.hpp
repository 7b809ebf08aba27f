#pragma once

#include <string>

#include "config/geometry/shape.hpp"
#include "coupling/results/report/map/map_sheet.hpp"

namespace coupling::report {

/// A part of the map of a page, drawn larger.
struct CutOut {
    std::string label;    ///< the whole of what it shows, for those who cannot see it
    config::Point2 low;   ///< south-western corner of what is shown
    config::Point2 high;  ///< north-eastern corner
    double units_per_m() const { return 1000.0 / (high.x_m - low.x_m); }
    double x_of(double x_m) const { return (x_m - low.x_m) * units_per_m(); }
    double y_of(double y_m) const { return (high.y_m - y_m) * units_per_m(); }
};

/// Hillshade, picture, contours, stems, sources, targets and nets of the sheet, whose definitions stand on
/// the page, below a drawing in units of a thousandth of the width, y down. Requires a width and a height
/// above 0.
std::string cut_out(const MapSheet& sheet, const CutOut& part, const std::string& drawing);

}  // namespace coupling::report
