#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "coupling/results/geopackage/database.hpp"
#include "forest/stand/species.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/years/queries.hpp"

namespace coupling::validation::years {

/// In SQL: the tables of runs over years as `bannwald info tables` declares them, with a first column `site`,
/// and the tables of the case (each CSV file of its folder that queries name, but for those called like a
/// table of the run). `trees` are all trees_YEAR.csv.
///
/// Empty fields are NULL. The column `species` of a case's table has codes, whatever its rows call them, and
/// several of them with blanks between. The column `line` is added: where a row stands in its file.
class ResultTables {
public:
    /// Throws InputError (data) for a table of the case that cannot be read or names an unknown species.
    ResultTables(const CaseFiles& files, const std::vector<Query>& queries,
                 const forest::SpeciesTable& species, const std::string& file_of_queries);

    /// The tables of the run of a site, from the folder that holds tables/.
    void add(const std::string& site, const std::filesystem::path& folder);
    /// A table of the program's own with some rows of text; numbers stay as they are written, or become real.
    void make(const std::string& table, const std::vector<std::string>& columns,
              const std::vector<std::vector<std::string>>& rows, bool as_real = false);
    /// More rows of such a table.
    void fill(const std::string& table, const std::vector<std::vector<std::string>>& rows);
    [[nodiscard]] geopackage::Database& database() { return database_; }
    /// Whether any query speaks of a table.
    [[nodiscard]] bool is_named(const std::string& table) const;
    /// Whether a table is one of the run.
    [[nodiscard]] bool is_of_run(const std::string& table) const { return run_tables_.contains(table); }
    /// Whether a file of the case became a table.
    [[nodiscard]] bool holds(const std::string& file) const { return case_files_.contains(file); }

private:
    void make_case_table(const CaseFiles& files, const std::string& file,
                         const forest::SpeciesTable& species);

    geopackage::Database database_;
    std::string all_sql_;
    std::set<std::string> run_tables_;
    std::set<std::string> case_files_;
};

/// A statement, or InputError (data) at its place with SQL's own words.
geopackage::Statement prepared(geopackage::Database& database, const Query& query);

/// All rows of a statement as text; its parameters are fields. Throws InputError (data) for a parameter that
/// is no field.
std::vector<std::vector<std::string>> rows_of(geopackage::Database& database, const Query& query,
                                              const Fields& fields = {});

/// The only value of a query; NaN for none.
double value_of(geopackage::Database& database, const Query& query, const Fields& fields);

}  // namespace coupling::validation::years
