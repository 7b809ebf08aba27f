#pragma once

#include <optional>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/geometry/shape.hpp"
#include "config/table/table.hpp"

namespace config {

/// "points, lines or polygons".
std::string kinds_in_words(const std::vector<Shape::Kind>& kinds);

/// The shape in the column `wkt` of a row; a problem where it is none or not of an `allowed` kind.
std::optional<Shape> shape_of(const Table& table, std::size_t row, const std::vector<Shape::Kind>& allowed,
                              Problems& problems);

}  // namespace config
