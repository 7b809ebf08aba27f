#pragma once

#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "validation/engine/forest_cases/yield_trial/comparison.hpp"

namespace coupling::validation::forest_cases {

/// Adds warnings about rows that no stand can have, from a mean diameter of 10 cm on: a basal area that stems
/// and mean diameter contradict by more than 15 %, a mean tree less than 15 or more than 150 times as high as
/// thick, from 15 cm on a volume below 0.15 or above 0.75 of basal area times height; stems that rise with
/// age; columns of height and diameter that look swapped [all choice]. `rows` are those of `table`, one each.
void warn_of_yield_rows(const config::Table& table, const std::vector<yield_trial::YieldTableRow>& rows,
                        config::Warnings& warnings);

/// Adds a problem for a site whose table or class has no row, with those that there are, for a table without
/// two ages, and for a name of a site that stands twice.
void check_sites(const config::Table& sites, const yield_trial::YieldCase& data,
                 const std::vector<int>& ages_years, const std::string& rows_file,
                 config::Problems& problems);

/// The ages that are drawn unless the user says which: the latest one that most sites reach, and the last.
std::vector<int> usual_drawn_ages(const yield_trial::YieldCase& data, const std::vector<int>& ages_years);

}  // namespace coupling::validation::forest_cases
