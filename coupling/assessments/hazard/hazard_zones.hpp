#pragma once

#include <array>
#include <vector>

#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/results/geopackage/results_package.hpp"

namespace coupling::hazard {

/// Areas of the zones of a map by level, as the layer of its rule has them.
std::array<double, levels> zone_areas_ha(const HazardMap& map, double smallest_m2);

/// The zones of all slopes as layers, one for each rule: hazard_zones by hazard.rule, and that of the rule
/// for comparison with its name behind. Outlines are smoothed; zones below hazard.smallest_zone_m2 are part
/// of what lies higher around them.
std::vector<geopackage::AreaLayer> zone_layers(const HazardResults& results);

}  // namespace coupling::hazard
