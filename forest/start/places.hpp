#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/patch.hpp"
#include "forest/start/diameters.hpp"

namespace forest {

/// Where a tree stands.
struct Place {
    PatchId patch{};
    double x_m = 0.0;
    double y_m = 0.0;
};

/// Key of the random numbers of places.
struct PlaceKey {
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
    std::uint64_t first_id = 0;  ///< of the first tree; each has numbers of its own
};

/// Places for trees of the given diameters (falling) on the patches of a stand [choice].
///
/// Thick trees come first, each to the patch that has least basal area for what it is to have: the mean,
/// times a factor drawn between 0.75 and 1.25. On its patch it keeps half the mean spacing of the stand from
/// all trees placed before, or as much as the best of 30 tries gives. In plenter stands trees stand at random
/// on their patch. In groups they stand in clusters (Neyman-Scott, standard radius 6 m, about 20 trees a
/// cluster), whatever that does to basal area.
///
/// `cover` says of each patch how much of it crowns cover: what a patch is to have is in proportion to it,
/// and one without cover has no tree. Empty: all patches alike.
///
/// `taken` are places where trees stand already. Requires at least one patch, and a cover above 0.
std::vector<Place> places_for(const PatchGrid& grid, std::span<const PatchId> patches,
                              std::span<const double> dbh_cm, Structure structure, const PlaceKey& key,
                              std::span<const Place> taken = {}, std::span<const double> cover = {});

}  // namespace forest
