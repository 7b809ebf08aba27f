#pragma once

#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"

namespace coupling::tables {

/// What there is to say about a table of a user before anybody reads its rows.
struct Findings {
    std::vector<std::string> notes;
    std::vector<config::Problem> warnings;
    std::vector<config::Problem> errors;
};

/// Makes a table or layer ready for its reader: one way for every table that a user hands over.
///
/// - Columns get the names that the program knows (formats/column_names.hpp), and the table is watched.
/// - Fields such as NA and n/a become empty; names and ids keep their text.
/// - Places: trees and logs get coordinates from their shapes; tables of shapes without a column `wkt` get
/// points
///   from x_m and y_m.
/// - Climate of days, of dates and in other units becomes that of our months (climate/delivered.hpp).
/// - Rows without a shape are left out where shapes are read.
/// - Targets and nets without an id or name are called by the numbers of their features.
///
/// `has_own_shapes`: a GIS wrote the shapes. `id_opening` stands before ids that are numbers of features, as
/// those of several files would be the same. All else comes back as findings.
Findings prepare(config::Table& table, const std::string& role, bool has_own_shapes,
                 const std::string& id_opening = "");

/// What became of the columns when all has been read: notes of those that were read under another name and of
/// those that nobody read; errors for unread ones that are a missing column in another unit.
Findings findings_of_use(const config::ColumnUse& use);

/// Findings for a command that prints remarks; warnings begin with "warning: ". Throws the errors.
void add_remarks(const Findings& findings, std::vector<std::string>& remarks);

/// Whether tables of a role are read for their shapes.
bool is_of_shapes(const std::string& role);

}  // namespace coupling::tables
