#pragma once

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"

namespace coupling {

/// Adds a problem (data) for each column of a table of interventions that no treatment knows; `note` is free.
void refuse_unknown_columns(const config::Table& table, config::Problems& problems);

}  // namespace coupling
