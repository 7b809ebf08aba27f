#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/hazard/hazard_map.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/assessments/hazard/hazard_rules.hpp"

namespace coupling::hazard {

/// What the forest does to a level, which is compared with that of the bare slope; `unclear`: they differ,
/// but by so few rocks that chance may do it.
enum class ForestChange { none, lowers, raises, unclear };
const char* change_name(ForestChange change);
ForestChange change_between(const RuledLevel& with_forest, const RuledLevel& bare);

/// Where the forest makes levels other than they are on the bare slope.
struct ForestChanges {
    std::size_t lowered_targets = 0;
    std::size_t raised_targets = 0;
    std::size_t unclear_targets = 0;
    /// Plan area of the map by the level that it has with forest.
    std::array<double, levels> lowered_ha{};
    std::array<double, levels> raised_ha{};
    std::array<double, levels> unclear_ha{};

    [[nodiscard]] double all_lowered_ha() const;
    [[nodiscard]] double all_raised_ha() const;
    [[nodiscard]] double all_unclear_ha() const;
    [[nodiscard]] bool raises() const { return raised_targets > 0 || all_raised_ha() > 0.0; }
};

/// Levels of the cells of a map: those that no rock passes are NaN and have none.
std::vector<Level> levels_of_cells(const config::Raster<float>& map);

/// Plan area of a level of a map by so few rocks that chance may do it.
double chance_area_ha(const HazardMap& map, Level level);

/// Levels of the same targets, and of the same cells, with forest and on the bare slope.
ForestChanges changes_between(std::span<const RuledLevel> targets_with_forest,
                              std::span<const RuledLevel> targets_bare, const HazardMap& with_forest,
                              const HazardMap& bare);

}  // namespace coupling::hazard
