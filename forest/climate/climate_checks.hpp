#pragma once

#include <map>
#include <string_view>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "forest/climate/series.hpp"

namespace forest {

/// Looks at whole columns before their values are judged one by one: radiation that looks like W/m2, deficits
/// that look like hPa, temperatures that look like kelvin. Throws InputError (data) with one sentence a
/// column.
void check_units_of_climate(const config::Table& table, std::string_view radiation_column,
                            std::string_view deficit_column);

/// Row of each month of a place, by year and month.
using RowsOfMonths = std::map<std::pair<int, int>, std::size_t>;

/// Adds a problem for each month whose values contradict each other, and warnings for what is only
/// suspicious.
void check_months(const ClimateSeries& series, const config::Table& table, const RowsOfMonths& rows,
                  config::Problems& problems, config::Warnings& warnings);

}  // namespace forest
