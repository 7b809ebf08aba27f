#pragma once

#include <vector>

#include "coupling/inputs/forest/forest_species.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "forest/start/starting_dead_wood.hpp"

namespace coupling {

/// Notes for each species with `browsed_percent` how much of it the inventory found browsed, how much deer
/// browse of the same stems in a year of the model, and the pressure (forest.browsing_pressure) at which both
/// agree. The inventory's shares change nothing else: the pressure is the user's.
void note_browsing(const std::vector<forest::OnPatches<forest::SaplingRecord>>& saplings,
                   const ForestSpecies& species, Reading& reading);

}  // namespace coupling
