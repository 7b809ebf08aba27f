#pragma once

#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/geometry/shape.hpp"

namespace config {

/// Coordinates beyond this are slips or damage, in whatever system of metres [choice].
inline constexpr double farthest_coordinate_m = 1e9;

/// Reads well-known text: POINT, LINESTRING, POLYGON with holes, and MULTI of each, in any case and spacing,
/// such as "LineString Z (177200 376900 1063, 177210 376950 1060)". Heights and measures (Z, M) are read
/// over. Curves (CIRCULARSTRING, COMPOUNDCURVE, CURVEPOLYGON, MULTICURVE, MULTISURFACE) become lines and
/// polygons: their arcs are stroked (`arcs`).
///
/// `start` is the place of the text's first character. Throws InputError (data) with file, line and column in
/// the text for anything else: other types, EMPTY, numbers that are none, coordinates beyond 1e9 m, lines of
/// one point, rings that are not closed or have fewer than four points, arcs of more than a million points.
Shape read_wkt(std::string_view text, const Place& start);

/// The third coordinate of each point of each part, in the order of the parts that `read_wkt` gives; a part
/// in which a point has none is empty. Throws as that does.
std::vector<std::vector<double>> read_wkt_heights(std::string_view text, const Place& start);

}  // namespace config
