#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"
#include "forest/treatment/area.hpp"

namespace forest {

/// Young trees from the nursery.
struct Planting {
    SpeciesId species{};
    double stems_pha = 2000.0;  ///< > 0, usually 1500-2500
    double height_m = 0.35;     ///< > 0, < 2
    int guarded_years = 0;      ///< for which a guard (tube, cage) keeps deer off each plant; 0: no guards
};

/// Young trees of a patch that count as established: 0.3 m and more [choice], up to this diameter.
inline constexpr double established_height_m = 0.3;
inline constexpr double young_dbh_cm = 5.0;

/// Young trees on every patch [1/ha]: saplings of 0.3 m and more and trees below 5 cm diameter.
std::vector<double> young_trees_pha(const Stand& stand);
/// Patches of an area with fewer young trees per hectare.
std::vector<PatchId> patches_with_fewer(const Stand& stand, const TreatmentArea& area, double young_pha);

/// Plants on patches, or on all whose middle lies in an area; parts of a stem a patch are decided by chance.
/// One in five dies within two years (forest/saplings/saplings.hpp). Gives the number of plants.
std::uint64_t plant_on(Stand& stand, std::span<const PatchId> patches, const Planting& planting,
                       std::uint64_t seed, std::uint32_t replicate);
std::uint64_t plant(Stand& stand, const TreatmentArea& area, const Planting& planting, std::uint64_t seed,
                    std::uint32_t replicate);

/// The same in clusters, as on steep slopes: 25 plants on every patch whose row and column both divide by
/// `every_patches` (1 or 2: 10 or 20 m apart). `stems_pha` has no say.
std::uint64_t plant_clusters_on(Stand& stand, std::span<const PatchId> patches, const Planting& planting,
                                int every_patches);
std::uint64_t plant_clusters(Stand& stand, const TreatmentArea& area, const Planting& planting,
                             int every_patches);

/// Young growth that is steered: where favoured species stand, a share of the others is cut.
struct Tending {
    std::span<const SpeciesId> favoured;
    double from_height_m = 0.5;  ///< of what is cut
    double to_height_m = 5.0;
    double cut_share = 0.5;  ///< [0, 1], of the stems of other species
};

/// What tending did.
struct TendingDone {
    std::uint64_t stems = 0;  ///< cut
    double area_ha = 0.0;     ///< of the patches where stems were cut
};

/// Cuts other species on patches of an area where a favoured one stands within the same heights; sapling or
/// young tree alike. Gives the number of stems cut.
TendingDone tend(Stand& stand, const TreatmentArea& area, const Tending& tending);

/// Keeps deer out of the patches of an area: nothing is browsed there for that many years
/// (forest/regeneration). A longer fence stays. Requires 1 to 1000 years. Gives the area that is fenced
/// longer than before [ha].
double fence(Stand& stand, const TreatmentArea& area, int years);

}  // namespace forest
