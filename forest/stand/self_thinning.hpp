#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Largest number of stems of one species that a hectare carries at a quadratic mean diameter: exp(a + b ln
/// Dg) (French national inventory, after matreex). Requires a diameter above 0.
double most_stems_pha(const Mortality& species, double mean_dbh_cm);

/// Side of the windows in which density is measured [patches]: 50 m.
inline constexpr int window_patches = 5;

/// Trees from this diameter on count in relative density; thinner ones are measured against the same line
/// among themselves.
inline constexpr double counted_dbh_cm = 7.0;

/// Squares of 50 x 50 m over a forest. A window less than half full of forest is joined to a neighbour: on a
/// strip of few patches a single large tree would count as many.
class ThinningWindows {
public:
    explicit ThinningWindows(const PatchGrid& grid);

    [[nodiscard]] std::size_t size() const { return areas_ha_.size(); }
    [[nodiscard]] std::size_t window_of(PatchId patch) const { return window_of_patch_[index_of(patch)]; }
    [[nodiscard]] double area_ha(std::size_t window) const { return areas_ha_[window]; }

private:
    std::vector<std::uint32_t> window_of_patch_;
    std::vector<double> areas_ha_;
};

/// Relative density of every window [-], trees of at least 7 cm: sum over species of stems / most stems at
/// the species' mean diameter. Unmanaged stands have 0.8 to 1.0.
std::vector<double> relative_densities(const Stand& stand, const SpeciesTable& species,
                                       const ThinningWindows& windows);

/// Basal area of every window [m2/ha], trees of at least 7 cm.
std::vector<double> window_basal_areas_m2pha(const Stand& stand, const ThinningWindows& windows);

/// Basal area of the thicker trees in the window of each tree [m2/ha], trees of at least 7 cm.
std::vector<double> larger_basal_areas_m2pha(const Stand& stand, const ThinningWindows& windows);

/// Scatter of growth in the order of dying, relative to it [choice].
inline constexpr double rank_scatter = 0.2;

/// Deaths by crowding: the fewest trees such that no window is denser than 1.
///
/// The trees whose diameter grew least this year die first [choice, as growth predicts death best: Bigler &
/// Bugmann 2003], with a scatter drawn by tree and year. Ranked by light alone, a tolerant understorey would
/// die before the pioneers that it is about to replace. Trees below 7 cm are thinned in the same way,
/// measured among themselves [choice].
std::vector<Removal> self_thinning(const Stand& stand, const SpeciesTable& species,
                                   const ThinningWindows& windows, std::uint64_t seed,
                                   std::uint32_t replicate);

}  // namespace forest
