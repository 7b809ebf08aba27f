#pragma once

#include <cstddef>

#include "validation/engine/forest_cases/belts/palette.hpp"

namespace coupling::validation::forest_cases::belts {

/// Biomass of the species of a site from bare ground on; all sites share `most_tpha` as the upper end.
Plot over_years(const BeltData& data, const Found& found, const Palette& palette, std::size_t site,
                double most_tpha);
/// Biomass, or its `shares`, in the judged years over elevation. Requires two places without another climate.
Plot over_elevation(const BeltData& data, const Found& found, const Palette& palette, bool shares);

}  // namespace coupling::validation::forest_cases::belts
