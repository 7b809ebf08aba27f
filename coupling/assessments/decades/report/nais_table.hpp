#pragma once

#include <span>
#include <string>

#include "coupling/assessments/decades/tables/nais_years.hpp"

namespace coupling::decades {

/// The forest against its target profiles in a few years: a cell for each course, criterion and year, with
/// letter, colour and share of area and replicates of the commonest status. HTML; empty without a profile.
std::string nais_table(const Names& names, std::span<const NaisCell> cells);

}  // namespace coupling::decades
