#pragma once

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/geopackage/results_package.hpp"

namespace coupling::hazard {

/// The targets with level, years between two hits and, where it is assessed, risk, once for each slope: layer
/// target_levels, from which a map can colour houses and roads.
geopackage::AreaLayer target_layer(const HazardResults& results);

}  // namespace coupling::hazard
