#pragma once

#include <vector>

#include "validation/engine/years/queries.hpp"

namespace coupling::validation::years {

/// The figures, tables and charts that every case over years has (standard_queries.sql).
std::vector<Query> standard_queries();

}  // namespace coupling::validation::years
