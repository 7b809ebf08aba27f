#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "config/grid/raster.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"

namespace coupling::hazard {

/// What the forest does to a level: it is compared with that of the bare slope.
enum class ForestChange { none, lowers, raises };
const char* change_name(ForestChange change);
ForestChange change_between(Level with_forest, Level bare);

/// Where the forest makes levels other than they are on the bare slope.
struct ForestChanges {
    std::size_t lowered_targets = 0;
    std::size_t raised_targets = 0;
    /// Plan area of the map by the level that it has with forest.
    std::array<double, levels> lowered_ha{};
    std::array<double, levels> raised_ha{};

    [[nodiscard]] double all_lowered_ha() const;
    [[nodiscard]] double all_raised_ha() const;
    [[nodiscard]] bool raises() const { return raised_targets > 0 || all_raised_ha() > 0.0; }
};

/// Levels of the cells of a map: those that no rock passes are NaN and have none.
std::vector<Level> levels_of_cells(const config::Raster<float>& map);

/// Levels of the same targets, and of the same cells, with forest and on the bare slope.
ForestChanges changes_between(std::span<const Level> targets_with_forest, std::span<const Level> targets_bare,
                              const config::Raster<float>& with_forest, const config::Raster<float>& bare);

}  // namespace coupling::hazard
