#pragma once

#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "validation/engine/forest_cases/plain_3pg/plain_3pg.hpp"

namespace coupling::validation::forest_cases {

// Warnings for columns that nothing reads, and for less rain than any forest has.

void warn_of_site(const config::Table& table, config::Warnings& warnings);
void warn_of_start(const config::Table& table, config::Warnings& warnings);
void warn_of_climate(const config::Table& table, const std::vector<plain_3pg::ClimateMonth>& months,
                     config::Warnings& warnings);

/// Adds a note where no species of a run stands in its first month.
void note_late_planting(const std::string& run, const plain_3pg::Inputs& inputs, config::Warnings& warnings);

/// Throws InputError (data) where the seasons of the climate contradict the latitude of the site.
void check_latitude(const config::Table& site, const config::Table& climate, const plain_3pg::Inputs& inputs);

}  // namespace coupling::validation::forest_cases
