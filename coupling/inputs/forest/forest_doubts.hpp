#pragma once

#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Doubts about climates that cannot be of the place of the forest, and about latitudes and changes that look
/// like slips; refuses a climate of the other half of the earth (plausible/climate_at.hpp).
/// `elevation_m`: mean of the forest.
void doubt_climates(const ForestSite& site, double elevation_m, Reading& reading);

/// Doubts about listed trees that make more than 100 m2/ha: girths for diameters, or another unit.
void doubt_dense_list(const ForestSite& site, Reading& reading);

/// Warns of a disturbance.first_year outside of the run.
void doubt_first_disturbance(const ForestSite& site, Reading& reading);

/// Warns of storms, beetle years and dry years that are asked for outside of the run, and of beetle years in
/// which no beetles are simulated.
void doubt_events(const ForestSite& site, Reading& reading);

}  // namespace coupling
