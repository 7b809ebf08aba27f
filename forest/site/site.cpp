#include "forest/site/site.hpp"

#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace forest {

namespace {

constexpr double elevation_band_m = 50.0;
constexpr double compass_part_deg = 45.0;
constexpr double level_deg = 5.0;  // flatter ground faces nowhere

/// Ground of the same key is taken to have the same climate and soil.
using SiteKey = std::tuple<long, int, double, int, double, double, double>;

SiteKey key_of(const Patch& patch) {
    const double degrees = patch.aspect.in_degrees();
    const int towards = patch.slope.in_degrees() < level_deg
                            ? -1
                            : static_cast<int>(std::lround(degrees / compass_part_deg)) % 8;
    const Soil& soil = patch.soil;
    return {static_cast<long>(std::floor(patch.ground_m / elevation_band_m)),
            towards,
            soil.water_capacity_mm,
            soil.texture_class,
            soil.fertility,
            soil.nitrogen_kg_per_ha_year,
            soil.ph};
}

LightSite light_site(const LightFrame& frame) {
    const std::vector<Exposure> exposures = exposures_of(frame.ground, frame.horizons);
    return {frame.sky, frame.ground, exposures, frame.settings};
}

}  // namespace

Site::Site(const PatchGrid& grid, config::Angle latitude, const LightFrame& light)
    : latitude_{latitude}, light_{light_site(light)}, windows_{grid} {
    assert(light.ground.elevation_m.frame == grid.frame());
    std::map<SiteKey, std::uint32_t> units;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> production_units;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Patch& patch = grid.patches()[i];
        const auto unit =
            units.emplace(key_of(patch), static_cast<std::uint32_t>(units_.size())).first->second;
        if (unit == units_.size()) {
            units_.push_back({.elevation_m = 0.0, .soil = patch.soil, .patches = {}});
        }
        units_[unit].patches.push_back(PatchId{static_cast<std::uint32_t>(i)});
        units_[unit].elevation_m += patch.ground_m;
        const auto shared = production_units
                                .emplace(std::pair{unit, patch.management_unit},
                                         static_cast<std::uint32_t>(production_units_.size()))
                                .first->second;
        if (shared == production_units_.size()) {
            production_units_.push_back({unit, patch.management_unit});
        }
        unit_of_patch_.push_back(unit);
        production_unit_of_patch_.push_back(shared);
        column_of_patch_.push_back(grid.frame().index(patch.cell));
        stores_.push_back({patch.soil.water_capacity_mm, soil_potential_of(patch.soil.texture_class)});
    }
    for (SiteUnit& unit : units_) {
        unit.elevation_m /= static_cast<double>(unit.patches.size());
    }
}

}  // namespace forest
