#pragma once

#include <string>
#include <vector>

#include "coupling/validation/case_files.hpp"
#include "coupling/validation/comparison.hpp"
#include "coupling/validation/recipe.hpp"

namespace coupling::validation {

/// A rock mass that breaks up, held against published figures of another one: scenario and terrain of the
/// case are a synthetic look-alike. Reads case.ini into `head`, too. `overrides` are settings of the
/// scenario. Throws InputError where the scenario cannot be opened.
Comparison read_collapse_case(const CaseFiles& files, CaseHead& head,
                              const std::vector<std::string>& overrides);

/// How many maxima a series has that stand out from the lows on both sides by a share of the largest value.
int peaks_of(const std::vector<double>& values, double share);

}  // namespace coupling::validation
