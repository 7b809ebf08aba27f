#pragma once

#include <cstddef>
#include <vector>

#include "forest/stand/patch.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// A species whose stomata were closed for this share of a growing season's demand has no seedlings, and its
/// trees begin to die. Chosen with forest_dry and the stems of forest_hauersteig in view: lower values keep
/// beech out of dry valleys, higher ones spare spruces where it is seldom dry. The same for all species: what
/// differs is how dry the soil must be for their stomata to close.
inline constexpr double tolerated_drought = 0.42;

/// How the drought of a year met each species on each patch: all species of the table, as seedlings of any
/// may come.
///
/// Stomata of a species close between field capacity and its threshold (production/soil_potential.hpp). How
/// far they were open over the growing season is a mean over the months above 5.5 degC, weighted by the
/// demand for water: a dry July counts more than a dry April.
class SpeciesDrought {
public:
    /// Without drought on any patch.
    SpeciesDrought(std::size_t patches, std::size_t species)
        : species_{species}, response_(patches * species, 1.0F) {}
    SpeciesDrought() = default;

    /// Mean opening of stomata [0, 1]; 1 = never dry.
    [[nodiscard]] double response(PatchId patch, SpeciesId species) const {
        return static_cast<double>(response_[index_of(patch) * species_ + index_of(species)]);
    }
    void set(PatchId patch, SpeciesId species, double response) {
        response_[index_of(patch) * species_ + index_of(species)] = static_cast<float>(response);
    }

private:
    std::size_t species_ = 0;
    std::vector<float> response_;
};

}  // namespace forest
