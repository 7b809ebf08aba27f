#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/run_settings.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"

namespace coupling {

/// Whether the trees of a run without years come from stands: a list of trees goes before them.
inline bool has_stands_of_today(const RunSettings& run, const TreeSettings& trees,
                                const ForestSettings& forest) {
    return run.years == 0 && trees.source().empty() &&
           !(forest.stand_records.empty() && forest.dbh_classes.empty());
}

/// Whether a setting says something of such stands.
inline bool describes_stands_of_today(std::string_view key) {
    constexpr std::array<std::string_view, 7> keys{"stands.map",    "stands.polygons", "stands.number",
                                                   "stands.cover",  "stands.records",  "stands.dbh_classes",
                                                   "forest.species"};
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace coupling
