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
        case ForestChange::unclear:
            return "unclear";
        case ForestChange::none:
            break;
    }
    return "same";
}

ForestChange change_between(const RuledLevel& with_forest, const RuledLevel& bare) {
    if (with_forest.level == bare.level) {
        return ForestChange::none;
    }
    const bool raises = with_forest.level > bare.level;
    if ((raises ? with_forest : bare).rests_on_chance()) {
        return ForestChange::unclear;
    }
    return raises ? ForestChange::raises : ForestChange::lowers;
}

double ForestChanges::all_lowered_ha() const {
    return std::accumulate(lowered_ha.begin(), lowered_ha.end(), 0.0);
}

double ForestChanges::all_raised_ha() const {
    return std::accumulate(raised_ha.begin(), raised_ha.end(), 0.0);
}

double ForestChanges::all_unclear_ha() const {
    return std::accumulate(unclear_ha.begin(), unclear_ha.end(), 0.0);
}

std::vector<Level> levels_of_cells(const config::Raster<float>& map) {
    std::vector<Level> found;
    found.reserve(map.values.size());
    for (const float level : map.values) {
        found.push_back(std::isnan(level) ? Level::none : static_cast<Level>(static_cast<int>(level)));
    }
    return found;
}

namespace {

/// What gives the level of a cell.
RuledLevel ruled_at(const HazardMap& map, std::size_t cell) {
    const float level = map.level.values[cell];
    if (std::isnan(level)) {
        return {};
    }
    return {.level = static_cast<Level>(static_cast<int>(level)),
            .energy = {},
            .rocks = static_cast<double>(map.rocks.values[cell])};
}

/// Cells are counted first: 100 of 1 m are 0.01 ha to the last bit, as everywhere else.
double cells_to_ha(double cells, const config::GridFrame& frame) {
    constexpr double m2_in_a_hectare = 1e4;
    return cells * frame.cell_area_m2() / m2_in_a_hectare;
}

}  // namespace

double chance_area_ha(const HazardMap& map, Level level) {
    double cells = 0.0;
    for (std::size_t cell = 0; cell < map.level.values.size(); ++cell) {
        const RuledLevel ruled = ruled_at(map, cell);
        cells += ruled.level == level && ruled.rests_on_chance() ? 1.0 : 0.0;
    }
    return cells_to_ha(cells, map.level.frame);
}

ForestChanges changes_between(std::span<const RuledLevel> targets_with_forest,
                              std::span<const RuledLevel> targets_bare, const HazardMap& with_forest,
                              const HazardMap& bare) {
    const config::GridFrame& frame = bare.level.frame;
    assert(targets_with_forest.size() == targets_bare.size() && with_forest.level.frame == frame);
    ForestChanges changes;
    for (std::size_t i = 0; i < targets_bare.size(); ++i) {
        const ForestChange change = change_between(targets_with_forest[i], targets_bare[i]);
        changes.lowered_targets += change == ForestChange::lowers ? 1 : 0;
        changes.raised_targets += change == ForestChange::raises ? 1 : 0;
        changes.unclear_targets += change == ForestChange::unclear ? 1 : 0;
    }
    for (std::size_t cell = 0; cell < bare.level.values.size(); ++cell) {
        const RuledLevel now = ruled_at(with_forest, cell);
        const ForestChange change = change_between(now, ruled_at(bare, cell));
        const auto level = static_cast<std::size_t>(now.level);
        changes.lowered_ha[level] += change == ForestChange::lowers ? 1.0 : 0.0;
        changes.raised_ha[level] += change == ForestChange::raises ? 1.0 : 0.0;
        changes.unclear_ha[level] += change == ForestChange::unclear ? 1.0 : 0.0;
    }
    for (auto* areas : {&changes.lowered_ha, &changes.raised_ha, &changes.unclear_ha}) {
        for (double& area : *areas) {
            area = cells_to_ha(area, frame);
        }
    }
    return changes;
}

}  // namespace coupling::hazard
