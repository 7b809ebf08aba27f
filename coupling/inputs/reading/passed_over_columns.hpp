#pragma once

#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Warns of columns that are passed over but may stand for a known one that the table lacks.
void warn_of_columns(const config::Table& table, const std::vector<std::string>& known, Reading& reading);

}  // namespace coupling
