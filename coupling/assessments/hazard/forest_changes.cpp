#include "coupling/assessments/hazard/forest_changes.hpp"

#include <cmath>
#include <numeric>

#include "coupling/assessments/hazard/hazard_results.hpp"

namespace coupling::hazard {
namespace {

/// Cells that no rock passes have no value.
Level level_in_cell(const SlopeHazard& slope, std::size_t cell) {
    const float level = slope.map.level.values[cell];
    return std::isnan(level) ? Level::none : static_cast<Level>(static_cast<int>(level));
}

}  // namespace

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

std::optional<ForestChanges> changes_by_forest(const HazardResults& results) {
    if (results.slopes.size() < 2) {
        return std::nullopt;
    }
    const SlopeHazard& forest = results.slopes.front();
    const SlopeHazard& bare = results.slopes.back();
    ForestChanges changes;
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        const ForestChange change =
            change_between(forest.targets[i].ruled.level, bare.targets[i].ruled.level);
        changes.lowered_targets += change == ForestChange::lowers ? 1 : 0;
        changes.raised_targets += change == ForestChange::raises ? 1 : 0;
    }
    constexpr double m2_in_a_hectare = 1e4;
    const double cell_ha = forest.map.level.frame.cell_area_m2() / m2_in_a_hectare;
    for (std::size_t cell = 0; cell < forest.map.level.values.size(); ++cell) {
        const Level now = level_in_cell(forest, cell);
        const ForestChange change = change_between(now, level_in_cell(bare, cell));
        changes.lowered_ha[static_cast<std::size_t>(now)] += change == ForestChange::lowers ? cell_ha : 0.0;
        changes.raised_ha[static_cast<std::size_t>(now)] += change == ForestChange::raises ? cell_ha : 0.0;
    }
    return changes;
}

}  // namespace coupling::hazard
