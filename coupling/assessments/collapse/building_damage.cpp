#include "coupling/assessments/collapse/building_damage.hpp"

#include <algorithm>
#include <cmath>

#include "config/units/constants.hpp"
#include "coupling/results/figures/colours.hpp"

namespace coupling::collapse {

std::size_t BuildingDamage::walls_hit() const {
    return static_cast<std::size_t>(
        std::count_if(walls.begin(), walls.end(), [](const WallLoad& load) { return load.blocks > 0; }));
}

double BuildingDamage::largest_on_wall_j() const {
    double largest_j = 0.0;
    for (const WallLoad& load : walls) {
        largest_j = std::max(largest_j, load.largest_j);
    }
    return largest_j;
}

double BuildingDamage::energy_on_walls_j() const {
    double sum_j = 0.0;
    for (const WallLoad& load : walls) {
        sum_j += load.energy_j;
    }
    return sum_j;
}

std::vector<BuildingDamage> building_damage(const CollapseResults& results) {
    std::vector<BuildingDamage> all;
    for (std::size_t t = 0; t < results.site.targets.size(); ++t) {
        const rockfall::Target& target = results.site.targets[t];
        if (!target.is_area) {
            continue;
        }
        const FloorWatch& floor = results.record.floors[t];
        BuildingDamage& damage = all.emplace_back();
        damage.target = t;
        damage.floor_m2 = floor.floor_m2();
        damage.reached_m2 = floor.reached_m2(0.0);
        damage.reached_low_m2 = floor.reached_m2(intensity_limits_kj[0] * config::j_per_kj);
        damage.reached_high_m2 = floor.reached_m2(intensity_limits_kj[1] * config::j_per_kj);
        for (const Wall& wall : walls_of(target)) {
            damage.walls.push_back({damage.walls.size(), wall});
        }
        for (const TargetHit& hit : results.record.hits) {
            if (hit.target == static_cast<double>(t)) {
                WallLoad& load = damage.walls.at(static_cast<std::size_t>(hit.wall));
                ++load.blocks;
                load.energy_j += hit.energy_j;
                load.largest_j = std::max(load.largest_j, hit.energy_j);
            }
        }
    }
    return all;
}

}  // namespace coupling::collapse
