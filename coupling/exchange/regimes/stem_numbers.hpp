#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/declared.hpp"
#include "config/table/table.hpp"
#include "coupling/exchange/regimes/areas.hpp"
#include "coupling/exchange/regimes/intervention.hpp"

namespace coupling {

const config::Schema<StemsAtAge>& stem_number_columns();

/// Stems by age, such as those of a yield table, by stand and age. Other columns are read over.
///
/// Throws one InputError (data) for missing columns, an empty table, values out of range, and an age that a
/// stand has twice.
std::vector<StemsAtAge> read_stem_numbers(const config::Table& table);

/// Adds a problem where stems by stand meet areas that are no stands.
void check_ground(const Intervention& intervention, const std::string& file, config::Problems& problems);

/// Stems that stay on an area at an age [1/ha], straight between two ages of the table; none outside of them,
/// and for stands that it has not.
std::optional<double> stems_at(std::span<const StemsAtAge> stems, const Area& area, double age_years);

}  // namespace coupling
