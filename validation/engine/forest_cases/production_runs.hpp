#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/forest_cases/plain_3pg/plain_3pg.hpp"

namespace coupling::validation::forest_cases {

/// A figure of the reference and the row of our run that it is compared with.
struct ComparedFigure {
    std::size_t row = 0;
    double reference = 0.0;
};

/// What a reference gives of one of r3PG's columns: one figure or more.
struct ComparedColumn {
    const plain_3pg::Column* column = nullptr;
    std::vector<ComparedFigure> figures;
};

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
    std::string parameters_file;             ///< in messages
    std::vector<ComparedColumn> compared{};  ///< never empty
};

/// Rows that a run gives: one a species and month.
std::size_t rows_of(const plain_3pg::Inputs& inputs);

/// Reads runs.csv of a case forest_production and the tables that each of its rows names
/// (validation/README.md). Rows of a reference are found by month and species, in any order; it may leave
/// months and species out. What has not been computed before the first month is 0 in r3PG, and is not
/// compared.
///
/// Throws InputError (file, data) for what is missing or not plausible, for months outside the run, other
/// species, a month and species twice, and a reference without any figure to compare. Warns of columns that
/// nothing reads and of parameters that take a default.
std::vector<ReferenceRun> read_reference_runs(const CaseFiles& files, config::Warnings& warnings);

}  // namespace coupling::validation::forest_cases
