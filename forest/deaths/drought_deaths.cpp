#include "forest/deaths/drought_deaths.hpp"

#include <algorithm>
#include <cmath>

namespace forest {

double drought_death(double response, const DroughtDeaths& law) {
    const double beyond =
        std::clamp((1.0 - response - tolerated_drought) / (1.0 - tolerated_drought), 0.0, 1.0);
    return law.at_full_drought * beyond * std::sqrt(beyond);
}

std::vector<double> drought_death_chances(const Stand& stand, const SpeciesDrought& drought,
                                          const DroughtDeaths& law) {
    std::vector<double> chances;
    chances.reserve(stand.trees().size());
    for (const Tree& tree : stand.trees()) {
        chances.push_back(drought_death(drought.response(tree.patch, tree.species), law));
    }
    return chances;
}

}  // namespace forest
