#pragma once

#include <string>
#include <vector>

#include "coupling/results/report/map/labels.hpp"

namespace coupling::report {

/// A map as those who draw on it see it, in units of the drawing.
struct SheetSize {
    double width = 0.0;
    double height = 0.0;
    double units_per_m = 1.0;
    double lettering = 13.0;  ///< size of the type
};

/// What both cover, with their light grounds: no place for names.
std::vector<LetteredBox> furniture_boxes(const SheetSize& sheet);

/// In the lower left corner, about a sixth of the sheet long.
std::string scale_bar(const SheetSize& sheet);
/// In the upper right corner.
std::string north_arrow(const SheetSize& sheet);

}  // namespace coupling::report
