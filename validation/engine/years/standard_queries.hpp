#pragma once

#include <vector>

#include "validation/engine/years/queries.hpp"
#include "validation/engine/years/years_case.hpp"

namespace coupling::validation::years {

/// The figures, tables and charts that every case over years has (standard_queries.sql).
std::vector<Query> standard_queries();

/// Those that a case wants: the standard ones and its own. Throws InputError where there are none, or its
/// file of figures is missing.
std::vector<Query> queries_of(const CaseFiles& files, const YearsSettings& settings);

}  // namespace coupling::validation::years
