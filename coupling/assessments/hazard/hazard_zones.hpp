#pragma once

#include <vector>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/geopackage/results_package.hpp"

namespace coupling::hazard {

/// The zones of all slopes as the layer hazard_zones: levels by the return period of the release and of the
/// arrival, without zones below hazard.smallest_zone_m2, with smoothed outlines.
geopackage::AreaLayer zones_layer(const HazardResults& results);

}  // namespace coupling::hazard
