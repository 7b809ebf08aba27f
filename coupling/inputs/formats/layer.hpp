#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::formats {

/// A table and the coordinate system that its file names. Shapes stand as well-known text in the column
/// `wkt`, whatever the file: one reader checks them all, and the shortest text of a number is that number.
struct Layer {
    config::Table table;
    std::string projection;  ///< well-known text, empty where the file names none
};

/// Names of layers as messages list them: 'roads', 'houses'; the first of many.
std::string listed(const std::vector<std::string>& names);

}  // namespace coupling::formats
