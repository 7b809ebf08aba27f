#pragma once

#include <vector>

#include "coupling/assessments/collapse/collapse_results.hpp"

namespace coupling::collapse {

/// What came to one wall of a target that is an area: blocks count at the wall by which they first reached
/// it, with their energy then.
struct WallLoad {
    std::size_t number = 0;
    Wall wall;
    std::size_t blocks = 0;
    double largest_j = 0.0;
    double energy_j = 0.0;  ///< sum
};

/// What blocks did to a target that is an area (`FloorWatch`).
struct BuildingDamage {
    std::size_t target = 0;
    double floor_m2 = 0.0;
    double reached_m2 = 0.0;
    double reached_low_m2 = 0.0;   ///< by a block of at least the lower limit of intensity
    double reached_high_m2 = 0.0;  ///< by one of at least the upper limit
    std::vector<WallLoad> walls;

    [[nodiscard]] double reached_share() const { return floor_m2 > 0.0 ? reached_m2 / floor_m2 : 0.0; }
    [[nodiscard]] std::size_t walls_hit() const;
    [[nodiscard]] double largest_on_wall_j() const;
    [[nodiscard]] double energy_on_walls_j() const;
};

/// Of the targets that are areas, in their order.
std::vector<BuildingDamage> building_damage(const CollapseResults& results);

}  // namespace coupling::collapse
