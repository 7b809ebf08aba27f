#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/engine/forest_cases/belts/palette.hpp"

namespace coupling::validation::forest_cases::belts {

/// Biomass by species, structure, dead wood, groups and, where storms or beetles are simulated, what they
/// took. `values` are the figures of the case by name.
std::vector<PlainTable> tables_of(const BeltData& data, const Found& found, const Palette& palette,
                                  const std::map<std::string, double>& values);

}  // namespace coupling::validation::forest_cases::belts
