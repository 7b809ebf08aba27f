#include "coupling/assessments/hazard/hazard_zones.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/hazard/hazard_colours.hpp"
#include "coupling/assessments/hazard/zones/zone_outlines.hpp"
#include "coupling/assessments/hazard/zones/zone_sieve.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
using geopackage::ColumnType;

std::string to_square_metres(double area_m2) {
    return config::to_text(std::round(area_m2));
}

/// The zones of all slopes by one of the rules of a slope.
geopackage::AreaLayer layer_of(const HazardResults& results, HazardMap SlopeHazard::*map,
                               const std::string& name) {
    const double smallest_m2 = results.scenario.hazard.smallest_zone_m2;
    geopackage::AreaLayer layer{
        name,
        joined("Hazard zones with smoothed outlines, those below ", config::to_text(smallest_m2),
               " m2 part of what lies higher around them; rule: ",
               rule_name((results.slopes.front().*map).rule), "."),
        {{"cover", ColumnType::text, "forest or bare"},
         {"rule", ColumnType::text, "rule that the level follows"},
         {"level", ColumnType::text, "hazard level"},
         {"level_number", ColumnType::whole, "the same as a number"},
         {"area_m2", ColumnType::number, "area of the zone"},
         {"smallest_zone_m2", ColumnType::number,
          "smaller zones take the level around them if it is higher"}},
        {},
        "level",
        {}};
    for (std::size_t level = 1; level < levels; ++level) {
        layer.classes.push_back({level_names[level], level_names[level], level_colours()[level].colour});
    }
    for (const SlopeHazard& slope : results.slopes) {
        const HazardMap& drawn = slope.*map;
        for (zones::ZoneOutline& zone :
             zones::outlines_of(zones::without_small_zones(drawn.level, smallest_m2))) {
            layer.rows.push_back(
                {{name_of(slope.cover), rule_name(drawn.rule), level_names[zone.level],
                  std::to_string(zone.level), to_square_metres(zone.area_m2), config::to_text(smallest_m2)},
                 std::move(zone.rings)});
        }
    }
    return layer;
}

}  // namespace

std::array<double, levels> zone_areas_ha(const HazardMap& map, double smallest_m2) {
    constexpr double ha_per_m2 = 1e-4;
    std::array<double, levels> areas{};
    for (const zones::ZoneOutline& zone :
         zones::outlines_of(zones::without_small_zones(map.level, smallest_m2))) {
        areas[zone.level] += ha_per_m2 * zone.area_m2;
    }
    return areas;
}

std::vector<geopackage::AreaLayer> zone_layers(const HazardResults& results) {
    return {layer_of(results, &SlopeHazard::map, "hazard_zones"),
            layer_of(results, &SlopeHazard::compared,
                     joined("hazard_zones_", rule_name(results.slopes.front().compared.rule)))};
}

}  // namespace coupling::hazard
