#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "config/table/table.hpp"

namespace coupling::page_figures {

/// What a sentence says in words: name of a target, a slope.
using Words = std::map<std::string, std::string>;

/// Finds a table by its name without ".csv".
using Tables = std::function<const config::Table&(const std::string& name)>;

/// A number from tables, and how far it may be from the one that the table was written from.
struct TableFigure {
    double value = 0.0;
    double rounding = 0.0;
    bool is_empty = false;      ///< the field of the table is
    bool may_be_empty = false;  ///< rounded values do not tell whether it is
    bool is_of_map = false;     ///< no table has it: counted on a map, a drawing or the list of trees
};

/// Computes a source. Its parts are joined by " * ", " / ", " + " and " - ", from left to right. Each part is
/// a number, "none" for a field that is left empty, "map" for what no table has, or the name of a table,
/// conditions (=, !, < and >; "cause!felled": any other), and a column, such as
///
///     targets name={part} cover={slope} share_percent
///     arrivals target_id=road energy_kj>30 count()
///
/// `{word}` stands for what the sentence says; a cover is "forest" where the word speaks of a forest.
/// `count()` is the number of rows, `sum(column)`, `max(column)` take all of them, `mean(column)` is the mean
/// over the replicates of what each has in them, `low90(column)` and `high90(column)` the ends of its 90 %
/// interval; columns that are to be added are joined by "+". A column alone needs exactly one row.
/// Throws std::runtime_error where that is not so.
TableFigure figure_of(std::string_view source, const Words& words, const Tables& tables);

/// The field of a table, as a text.
std::string text_of(std::string_view source, const Words& words, const Tables& tables);

/// Whether a number as the page shows it, such as "9660" or "1.7e-4", is a rounding of a figure. A dash is
/// that of an empty field.
bool agree(const std::string& shown, const TableFigure& figure);

/// Another number of the same form, some units of its last digit away, and further than a table rounds.
std::string changed(const std::string& shown, double rounding);

}  // namespace coupling::page_figures
