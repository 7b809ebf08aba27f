#include "coupling/inputs/forest/listed_density.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace coupling {

ListedDensity listed_density(const std::vector<TreeRecord>& trees) {
    assert(!trees.empty());
    constexpr double cell_m = 20.0;
    constexpr double m2_in_a_hectare = 1e4;
    constexpr double m_per_cm = 0.01;
    std::set<std::pair<long, long>> wooded;
    double basal_area_m2 = 0.0;
    for (const TreeRecord& tree : trees) {
        wooded.emplace(std::lround(std::floor(tree.stem.x_m / cell_m)),
                       std::lround(std::floor(tree.stem.y_m / cell_m)));
        const double dbh_m = m_per_cm * tree.stem.dbh_cm;
        basal_area_m2 += 0.25 * std::numbers::pi * dbh_m * dbh_m;
    }
    const double wooded_ha = cell_m * cell_m / m2_in_a_hectare * static_cast<double>(wooded.size());
    return {wooded_ha, static_cast<double>(trees.size()) / wooded_ha, basal_area_m2 / wooded_ha};
}

}  // namespace coupling
