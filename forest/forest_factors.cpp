#include "forest/forest_factors.hpp"

#include <utility>

namespace forest {

SpeciesTable with_factors(const SpeciesTable& species, const ForestFactors& factors) {
    SpeciesTable changed = species;
    for (std::size_t i = 0; i < species.size(); ++i) {
        const auto id = static_cast<SpeciesId>(i);
        Species kind = species[id];
        kind.response.npp_multiplier *= factors.growth;
        kind.seeds.seedlings_pm2 *= factors.regeneration;
        changed.replace(id, std::move(kind));
    }
    return changed;
}

Parameters with_factors(const Parameters& parameters, const ForestFactors& factors) {
    Parameters changed = parameters;
    changed.mortality.all *= factors.deaths;
    return changed;
}

}  // namespace forest
