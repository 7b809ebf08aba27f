#pragma once

#include <cstddef>
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
    bool is_free = true;     ///< covers neither a shape nor another name
    bool is_hidden = false;  ///< would cover another name or leave the sheet: not to be written
};

/// What lettering covers.
struct LetteredBox {
    double west;
    double north;
    double east;
    double south;
};

bool overlap(const LetteredBox& a, const LetteredBox& b);

/// What a text covers that begins at x, on its base line y.
LetteredBox box_of(const std::string& text, double x, double y, double lettering);

/// A place for each name beside its shape, so that names cover neither a shape nor each other nor what is
/// `taken` where that can be helped. None leaves the sheet. A name without such a place may cover a shape,
/// but nothing that is written: without room for that it is hidden. `lettering` is the size of the type,
/// `width` and `height` those of the sheet.
std::vector<NamePlace> place_names(const std::vector<NamedShape>& shapes, std::vector<LetteredBox> taken,
                                   double lettering, double width, double height);

/// Names on a map as SVG, and of how many shapes on the sheet the name is left out.
struct WrittenNames {
    std::string svg;
    std::size_t left_out = 0;
};

/// Of a village only the names that cover no shape: all of them would hide the map.
WrittenNames write_names(const std::vector<NamedShape>& shapes, std::vector<LetteredBox> taken,
                         double lettering, double width, double height);

}  // namespace coupling::report
