#pragma once

#include <vector>

#include "coupling/inputs/places/records.hpp"

namespace coupling {

/// Stems of a list of trees per hectare of the ground on which they stand.
struct ListedDensity {
    double wooded_ha = 0.0;  ///< cells of 20 m that hold a tree [choice]
    double stems_pha = 0.0;
    double basal_area_m2pha = 0.0;
};

/// A list that lost half of its rows, or lists each tree twice, shows in it. All trees count, dead ones too.
/// Requires a tree.
ListedDensity listed_density(const std::vector<TreeRecord>& trees);

}  // namespace coupling
