#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::formats {

/// Ending of attributes that hold coordinates beside a shape: the shape counts, and a warning names places
/// that differ.
inline constexpr std::string_view superseded_by_shape = "_attribute";

/// Gives the columns of a table the names that the program knows for its role (`trees`, `targets`, ...): the
/// form of a name does not count (config/table/column_form.hpp), a Shapefile cuts names off after ten
/// letters, and config/data/column_names.csv has words of other programs and languages. A name that is there
/// already is left alone. The table is watched from then on. Returns what is wrong with columns that are in
/// another unit.
std::vector<config::Problem> name_columns(config::Table& table, std::string_view role);

/// A column in another unit than ours, whose numbers were made ours.
struct UnitChange {
    std::string found;   ///< the column as the file has it: "DBH_mm"
    std::string column;  ///< ours: "dbh_cm"
    std::string sum;     ///< what was done with each number: " / 10"
};

/// Makes numbers ours where a column of the role, or a word for it, names another unit of the same kind in
/// its header (`DBH_mm`, `Höhe [cm]`, `height_ft`), and gives it our name. A column stays as it is where the
/// table has ours, too, and where a field holds no number: `name_columns` refuses it then.
std::vector<UnitChange> take_other_units(config::Table& table, std::string_view role);

/// " * 3.6", " / 10".
std::string times_in_words(double factor);

/// Columns of a table that may be meant as a column of ours that it lacks, because a part of their name is
/// one of its words: between underscores, blanks or at a capital within (`hoehe_gesamt_m`, `treeHeight`), or
/// the letters at their beginning (`baumartlat`). `whole_words` leaves the latter out. The likeliest first,
/// as the file has them. Columns that are ours under another name are none. They may only be proposed: a part
/// of a name says too little to read a column by it.
std::vector<std::string> columns_by_part(const config::Table& table, std::string_view role,
                                         std::string_view wanted, bool whole_words = false);

/// Gives a list of trees or logs (`role`) its coordinates from its shapes: `x_m` and `y_m` of points; of logs
/// that are lines, from end to end, `x1_m`, `y1_m`, `x2_m`, `y2_m`. `shapes_win` says that attributes of
/// these names may be older than the shapes and are replaced; the number of rows whose place then differs by
/// more than a metre comes back.
std::size_t take_coordinates(config::Table& table, std::string_view role, bool shapes_win);

}  // namespace coupling::formats
