#pragma once

#include <optional>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/geometry/shape.hpp"
#include "config/table/table.hpp"

namespace coupling {

/// The shape in the column `wkt` of a row; a problem where it is none or not of an `allowed` kind.
std::optional<config::Shape> shape_of(const config::Table& table, std::size_t row,
                                      const std::vector<config::Shape::Kind>& allowed,
                                      config::Problems& problems);

}  // namespace coupling
