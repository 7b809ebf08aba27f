#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"

namespace coupling {

/// The known column that a name may stand for, or "": one with nearly the same letters (`treshold_deg`), with
/// the same letters but for `_` (`rt`), or the same quantity without unit or in another one (`speed`,
/// `mass_tonnes`, `velocity_mps`). Requires a name that is not itself known.
std::string meant_column(const std::string& name, const std::vector<std::string>& known);

/// Columns that are none of the known ones but may stand for one that the table lacks. They count as named.
/// With a role also those that have a word for a measured quantity in their name: `hoehe_gesamt_m`.
std::vector<config::Problem> misspelt_columns(const config::Table& table,
                                              const std::vector<std::string>& known,
                                              std::string_view role = "");

/// Whether a column holds names or ids: `name`, `label`, `code` and `..._id`.
bool names_things(std::string_view column);

/// What a spreadsheet would take for a formula when it opens results: ids and names (columns `name`, `label`,
/// `code` and `..._id`) that begin with =, +, - or @ and are no numbers. They go unchanged into the results,
/// so that tables can be joined with the user's own. One problem a column.
std::vector<config::Problem> formula_warnings(const config::Table& table);

}  // namespace coupling
