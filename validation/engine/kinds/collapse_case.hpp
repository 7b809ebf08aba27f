#pragma once

#include <string>
#include <vector>

#include "validation/engine/case/case_files.hpp"
#include "validation/engine/case/comparison.hpp"
#include "validation/engine/slope/recipe.hpp"

namespace coupling::validation {

/// A rock mass that breaks up, held against published figures of another one: scenario and terrain of the
/// case are a synthetic look-alike. Reads case.ini into `head`, too. `overrides` are settings of the
/// scenario. Throws InputError where the scenario cannot be opened.
Comparison read_collapse_case(const CaseFiles& files, CaseHead& head,
                              const std::vector<std::string>& overrides);

/// How many maxima a series has that stand out from the lows on both sides by a share of the largest value.
int peaks_of(const std::vector<double>& values, double share);

}  // namespace coupling::validation
