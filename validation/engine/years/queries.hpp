#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"

namespace coupling::validation::years {

/// What a statement of a file of figures is for.
enum class QueryUse : std::uint8_t { definition, figure, table, stack, lines, warning, error };

/// A statement of SQL with the comment line above it that says what it gives.
///
///     -- figure NAME | TABLE | LABEL | UNIT    one value for each row of TABLE (a table or view); with a
///     fifth
///                                              part that is a number, observed
///     -- table CAPTION                         a table of the page, its columns named by their aliases
///     -- stack TITLE                           charts of layers: plot, layer, x, y; the aliases of x and y
///                                              are the titles of the axes
///     -- lines TITLE                           charts of lines and dots: plot, name, style, label, x, y
///     -- warning FILE | TEXT                   a row is a line of FILE (its first column) that looks wrong
///     -- error FILE | FOUND | EXPECTED         the same, and is refused
///
/// Without such a line it defines a view. {column} in a head stands for a field of the row, in those of the
/// last two of the first row, :column in the statement of a figure likewise.
struct Query {
    QueryUse use = QueryUse::definition;
    std::string title;  ///< name, caption, title, or what was found
    std::string rows;   ///< the table of a figure, the file of a warning or error
    std::string label;  ///< of a figure; what is expected
    std::string unit;
    std::string observed;  ///< of a figure: a number, or ""
    std::string sql;
    config::Place place;  ///< of the first line of its statement
};

/// The statements of a text, each ending with a semicolon at the end of a line. Throws InputError (data) for
/// heads that lack something and a last statement without an end.
std::vector<Query> read_queries(std::string_view text, const std::string& file);

/// Fields of a row by the names of their columns.
using Fields = std::map<std::string, std::string>;

/// The text with each {column} replaced by its field. Throws InputError (data) at `place` for a column that
/// the row has not.
std::string filled(const std::string& text, const Fields& fields, const config::Place& place);

}  // namespace coupling::validation::years
