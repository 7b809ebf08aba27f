#include "coupling/assessments/hazard/forest_changes.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

namespace coupling::hazard {
const char* change_name(ForestChange change) {
    switch (change) {
        case ForestChange::lowers:
            return "lower";
        case ForestChange::raises:
            return "higher";
        case ForestChange::none:
            break;
    }
    return "same";
}

ForestChange change_between(Level with_forest, Level bare) {
    return with_forest < bare   ? ForestChange::lowers
           : with_forest > bare ? ForestChange::raises
                                : ForestChange::none;
}

double ForestChanges::all_lowered_ha() const {
    return std::accumulate(lowered_ha.begin(), lowered_ha.end(), 0.0);
}

double ForestChanges::all_raised_ha() const {
    return std::accumulate(raised_ha.begin(), raised_ha.end(), 0.0);
}

std::vector<Level> levels_of_cells(const config::Raster<float>& map) {
    std::vector<Level> found;
    found.reserve(map.values.size());
    for (const float level : map.values) {
        found.push_back(std::isnan(level) ? Level::none : static_cast<Level>(static_cast<int>(level)));
    }
    return found;
}

ForestChanges changes_between(std::span<const Level> targets_with_forest, std::span<const Level> targets_bare,
                              const config::Raster<float>& with_forest, const config::Raster<float>& bare) {
    assert(targets_with_forest.size() == targets_bare.size() && with_forest.frame == bare.frame);
    ForestChanges changes;
    for (std::size_t i = 0; i < targets_bare.size(); ++i) {
        const ForestChange change = change_between(targets_with_forest[i], targets_bare[i]);
        changes.lowered_targets += change == ForestChange::lowers ? 1 : 0;
        changes.raised_targets += change == ForestChange::raises ? 1 : 0;
    }
    const std::vector<Level> now_at = levels_of_cells(with_forest);
    const std::vector<Level> bare_at = levels_of_cells(bare);
    for (std::size_t cell = 0; cell < bare_at.size(); ++cell) {
        const Level now = now_at[cell];
        const ForestChange change = change_between(now, bare_at[cell]);
        changes.lowered_ha[static_cast<std::size_t>(now)] += change == ForestChange::lowers ? 1.0 : 0.0;
        changes.raised_ha[static_cast<std::size_t>(now)] += change == ForestChange::raises ? 1.0 : 0.0;
    }
    // Cells are counted first: 100 of 1 m are 0.01 ha to the last bit, as everywhere else.
    constexpr double m2_in_a_hectare = 1e4;
    for (auto* areas : {&changes.lowered_ha, &changes.raised_ha}) {
        for (double& area : *areas) {
            area = area * bare.frame.cell_area_m2() / m2_in_a_hectare;
        }
    }
    return changes;
}

}  // namespace coupling::hazard
