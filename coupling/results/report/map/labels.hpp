#pragma once

#include <string>
#include <vector>

namespace coupling::report {

/// A point of a drawing, y down.
struct DrawnPoint {
    double x;
    double y;
};

/// A line or the rim of an area with the name that belongs to it.
struct NamedShape {
    std::string name;
    std::vector<std::vector<DrawnPoint>> parts;
};

/// Where a name is written: the middle of its base line.
struct NamePlace {
    double x;
    double y;
};

/// A place for each name beside its shape, so that names neither cover a shape nor each other where that can
/// be helped. `lettering` is the size of the type, `width` and `height` those of the sheet.
std::vector<NamePlace> place_names(const std::vector<NamedShape>& shapes, double lettering, double width,
                                   double height);

}  // namespace coupling::report
