#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/validation/case_files.hpp"
#include "coupling/validation/forest_cases/plain_3pg/plain_3pg.hpp"

namespace coupling::validation::forest_cases {

/// A run of another program and the inputs it was made with.
struct ReferenceRun {
    std::string name;
    plain_3pg::Inputs inputs;
    plain_3pg::Settings settings;
    config::Table table;
    /// For each row of the table the row of our run with its month and species.
    std::vector<std::size_t> row_in_run;
    double floor = 0.0;  ///< differences are relative to the reference, or to this where it is smaller
    std::string source;
};

/// Rows that a run gives: one a species and month.
std::size_t rows_of(const plain_3pg::Inputs& inputs);

/// Reads runs.csv of a case forest_production and the tables that each of its rows names
/// (validation/README.md). Rows of a reference are found by month and species, in any order; it may leave
/// months and species out. Throws InputError (file, data) for what is missing or not plausible, for months
/// outside the run, other species, and a month and species twice.
std::vector<ReferenceRun> read_reference_runs(const CaseFiles& files);

}  // namespace coupling::validation::forest_cases
