#pragma once

#include <set>
#include <string>

#include "config/errors/warnings.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/slope/recipe.hpp"

namespace coupling::validation::forest_cases {

/// Adds a warning for each table in a folder of the user's that a kind does not read: a misspelt optional
/// table, such as felled.csv for fell_list.csv, would otherwise be left out in silence. Names the nearest
/// table that the folder does not have. Texts other than CSV are the user's own.
void warn_of_unread_files(CaseKind kind, const CaseFiles& files, config::Warnings& warnings);
/// The same of a case that reads some tables, and criteria.csv as all do.
void warn_of_unread_files(const CaseFiles& files, std::set<std::string> read, config::Warnings& warnings);

}  // namespace coupling::validation::forest_cases
