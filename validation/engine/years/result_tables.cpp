#include "validation/engine/years/result_tables.hpp"

#include <limits>

#include "config/text/joined.hpp"
#include "config/text/words_of_list.hpp"
#include "coupling/assessments/decades/decade_layouts.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"

namespace coupling::validation::years {
namespace {

using config::joined;
using geopackage::Database;
using geopackage::sql_name;
using geopackage::Statement;

/// `trees` for trees_YEAR.csv and trees_600.csv.
std::string table_of_file(const std::string& file) {
    const std::string stem = std::filesystem::path{file}.stem().string();
    return stem.starts_with("trees_") ? "trees" : stem;
}

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Words stay words, names of sites as they are written, such as 0500. Whole numbers of results become real,
/// as SQLite divides whole ones as such; those of a case's table stay as they are written, for the names of
/// figures.
void create(Database& database, const std::string& table, const std::vector<std::string>& columns,
            const char* affinity) {
    std::string list;
    for (const std::string& column : columns) {
        list += joined(list.empty() ? "" : ", ", sql_name(column),
                       column == "site" || column == "figure" ? " TEXT" : affinity);
    }
    database.execute(joined("CREATE TABLE ", sql_name(table), " (", list, ");"));
}

Statement insert_into(Database& database, const std::string& table, std::size_t columns) {
    std::string marks;
    for (std::size_t i = 0; i < columns; ++i) {
        marks += i == 0 ? "?" : ", ?";
    }
    return database.prepare(joined("INSERT INTO ", sql_name(table), " VALUES (", marks, ");"));
}

void bind_field(Statement& statement, std::size_t parameter, std::string_view field) {
    const int number = static_cast<int>(parameter);
    field.empty() ? statement.bind_null(number) : statement.bind(number, field);
}

/// Codes for the species that a field names.
std::string codes_of(const config::Table& table, std::size_t row, const forest::SpeciesTable& species,
                     config::Problems& problems) {
    std::string codes;
    for (const std::string& word : config::words_between_blanks(table.text(row, "species"))) {
        if (const auto kind = species.find(word, table.place(row, "species"), problems)) {
            codes += joined(codes.empty() ? "" : " ", species[*kind].code);
        }
    }
    return codes;
}

[[noreturn]] void fail_at(const config::Place& place, const config::InputError& error) {
    config::fail(config::ExitCode::data, place, error.problems().front().found,
                 "a statement of SQLite over the tables of `bannwald info tables` and of the case");
}

void bind_fields(Statement& statement, const Query& query, const Fields& fields) {
    const std::vector<std::string> parameters = statement.parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto field = fields.find(parameters[i].substr(1));
        if (field == fields.end()) {
            config::fail(config::ExitCode::data, query.place, parameters[i],
                         "a column of the table that the head names");
        }
        bind_field(statement, i + 1, field->second);
    }
}

}  // namespace

ResultTables::ResultTables(const CaseFiles& files, const std::vector<Query>& queries,
                           const forest::SpeciesTable& species, const std::string& file_of_queries)
    : database_{file_of_queries, Database::Open::in_memory} {
    for (const Query& query : queries) {
        all_sql_ += joined(query.sql, query.rows, ";", query.title, ";", query.label, ";");
    }
    for (const TableLayout& layout : decades::decade_layouts()) {
        std::vector<std::string> columns{"site"};
        for (const Column& column : layout.columns) {
            columns.push_back(column.name);
        }
        create(database_, table_of_file(layout.file), columns, " REAL");
        run_tables_.insert(table_of_file(layout.file));
    }
    for (const auto& [file, text] : files.texts) {
        // An input of the scenario may be called stands.csv or trees.csv, as a table of the run is.
        const std::string table = table_of_file(file);
        if (file.ends_with(".csv") && !run_tables_.contains(table) && is_named(table)) {
            make_case_table(files, file, species);
            case_files_.insert(file);
        }
    }
}

bool ResultTables::is_named(const std::string& table) const {
    for (std::size_t at = all_sql_.find(table); at != std::string::npos; at = all_sql_.find(table, at + 1)) {
        const bool begins = at == 0 || !is_letter(all_sql_[at - 1]);
        if (begins && !is_letter(all_sql_[at + table.size()])) {
            return true;
        }
    }
    return false;
}

void ResultTables::make(const std::string& table, const std::vector<std::string>& columns,
                        const std::vector<std::vector<std::string>>& rows, bool as_real) {
    create(database_, table, columns, as_real ? " REAL" : " NUMERIC");
    fill(table, rows);
}

void ResultTables::fill(const std::string& table, const std::vector<std::vector<std::string>>& rows) {
    if (rows.empty()) {
        return;
    }
    Statement insert = insert_into(database_, table, rows.front().size());
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            bind_field(insert, i + 1, row[i]);
        }
        insert.run();
    }
}

void ResultTables::make_case_table(const CaseFiles& files, const std::string& file,
                                   const forest::SpeciesTable& species) {
    const config::Table table = files.table(file);
    config::Problems problems;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> columns = table.columns();
    columns.emplace_back("line");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        rows.emplace_back();
        for (const std::string& column : table.columns()) {
            rows.back().push_back(column == "species" ? codes_of(table, row, species, problems)
                                                      : table.text(row, column));
        }
        rows.back().push_back(std::to_string(table.place(row, columns.front()).line));
    }
    problems.throw_if_any();
    make(table_of_file(file), columns, rows);
}

void ResultTables::add(const std::string& site, const std::filesystem::path& folder) {
    database_.execute("BEGIN;");
    for (const std::filesystem::path& file : entries_of(folder / "tables")) {
        const std::string table = table_of_file(file.filename().string());
        if (!is_named(table)) {
            continue;
        }
        OwnRows rows{file};
        Statement insert = insert_into(database_, table, rows.columns().size() + 1);
        while (rows.next()) {
            bind_field(insert, 1, site);
            for (std::size_t i = 0; i < rows.fields().size(); ++i) {
                bind_field(insert, i + 2, rows.fields()[i]);
            }
            insert.run();
        }
    }
    database_.execute("COMMIT;");
}

Statement prepared(Database& database, const Query& query) {
    try {
        return database.prepare(query.sql);
    } catch (const config::InputError& error) {
        fail_at(query.place, error);
    }
}

std::vector<std::vector<std::string>> rows_of(Database& database, const Query& query, const Fields& fields) {
    Statement statement = prepared(database, query);
    bind_fields(statement, query, fields);
    std::vector<std::vector<std::string>> rows;
    try {
        while (statement.step()) {
            rows.emplace_back();
            for (int column = 0; column < statement.columns(); ++column) {
                rows.back().push_back(statement.text(column));
            }
        }
    } catch (const config::InputError& error) {
        fail_at(query.place, error);
    }
    return rows;
}

double value_of(Database& database, const Query& query, const Fields& fields) {
    Statement statement = prepared(database, query);
    bind_fields(statement, query, fields);
    return statement.step() && !statement.is_null(0) ? statement.number(0)
                                                     : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace coupling::validation::years
