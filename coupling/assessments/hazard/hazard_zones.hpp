#pragma once

#include <vector>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/geopackage/results_package.hpp"

namespace coupling::hazard {

/// The zones of all slopes as layers, one for each rule: hazard_zones by hazard.rule, and that of the rule for
/// comparison with its name behind. Outlines are smoothed; zones below hazard.smallest_zone_m2 are part of
/// what lies higher around them.
std::vector<geopackage::AreaLayer> zone_layers(const HazardResults& results);

}  // namespace coupling::hazard
