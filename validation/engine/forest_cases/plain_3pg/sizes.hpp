#pragma once

#include "validation/engine/forest_cases/plain_3pg/stand.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// First sizes of the mean trees, from biomass and stem numbers.
void start_sizes(Stand& stand, const Inputs& inputs, HeightModel height);

/// Sizes of the mean trees after biomass, stem numbers or leaves changed. Competition and relative height are
/// those of the sizes before, as in r3PG, which therefore goes over them twice.
void update_sizes(Stand& stand, const Inputs& inputs, HeightModel height);

/// The same only where something changed since.
void update_sizes_if_outdated(Stand& stand, const Inputs& inputs, HeightModel height);

/// Leaf area, and mass of the mean tree, of the present biomass.
void update_leaves_and_trees(Stand& stand);

/// Stem volume of a species [m3/ha].
double volume_m3pha(const SpeciesMonth& species, const Parameters& parameters);

/// Shares of the species in the basal area.
void update_basal_area_shares(Stand& stand);

}  // namespace coupling::validation::forest_cases::plain_3pg
