#pragma once

#include "config/errors/warnings.hpp"
#include "coupling/results/geopackage/database.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/years/queries.hpp"

namespace coupling::validation::years {

/// Asks a warning or an error of a case whether its tables hold what it looks for: adds the warning, throws
/// the error (InputError, data), each with the lines of its file.
void run_check(geopackage::Database& database, const Query& query, const CaseFiles& files,
               config::Warnings& warnings);

}  // namespace coupling::validation::years
