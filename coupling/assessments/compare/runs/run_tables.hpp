#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/table/table.hpp"

namespace coupling::compare {

// Tables of a finished run.

/// Throws config::InputError: (file) for a table that is missing or cannot be read, (data) for one without a
/// wanted column and for one that changed since its run (OwnRows, file_sums.hpp).
config::Table read_table(const std::filesystem::path& folder, const std::string& name,
                         const std::vector<std::string>& wanted);
bool has_table(const std::filesystem::path& folder, const std::string& name);
/// NaN for an empty field: not known. Throws config::InputError (data) for a field that is no number, or one
/// that no run gives (beyond 1e12).
double number(const config::Table& table, std::size_t row, const std::string& column);
/// The same of what is never negative: lengths, energies, shares.
double size(const config::Table& table, std::size_t row, const std::string& column);
/// A whole number from 0 on: rocks, members. Throws for an empty field too.
double count(const config::Table& table, std::size_t row, const std::string& column);
/// The climate of a row of a run over years; runs of earlier versions had but one.
std::string climate_of(const config::Table& table, std::size_t row);
/// "pfm1", in a climate with a name of its own "pfm1, climate warm".
std::string course_name(const std::string& regime, const std::string& climate);

}  // namespace coupling::compare
