#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Trees to fell, as places in trees(); each once. What selections have in common: `candidates` are places in
/// trees() (such as those in an area), `area_ha` the ground they stand on; seed trees are never chosen.
using Picks = std::vector<std::size_t>;

/// All of a diameter and more: group, slit and clear cuts, clearance of a shelter.
Picks all_trees(const Stand& stand, std::span<const std::size_t> candidates, double from_dbh_cm = 0.0);

/// The thinnest trees, until their share of the basal area is reached (usually 0.15-0.3); never more.
Picks thin_from_below(const Stand& stand, std::span<const std::size_t> candidates, double basal_area_share);
/// The same by share of the volume.
Picks thin_volume_from_below(const Stand& stand, const SpeciesTable& species,
                             std::span<const std::size_t> candidates, double volume_share);

/// The thinnest of the trees that may go, until the basal area of all candidates is no more than the target
/// [m2/ha]; all of them where that is not enough. Requires an area above 0.
Picks thin_to_basal_area(const Stand& stand, std::span<const std::size_t> candidates,
                         std::span<const std::size_t> may_go, double area_ha, double target_m2pha);

/// The same until all candidates have no more stems than the target [1/ha].
Picks thin_to_stems(const Stand& stand, std::span<const std::size_t> candidates,
                    std::span<const std::size_t> may_go, double area_ha, double target_pha);

/// So many of the thickest stems, groups of young trees as a whole; of equal diameters the first.
Picks thickest(const Stand& stand, std::span<const std::size_t> candidates, std::size_t stems);

/// Relative density of trees on an area [-]: of those of 7 cm and more, sum over species of stems / most
/// stems at the species' mean diameter (forest/stand/self_thinning.hpp). Requires an area above 0.
double relative_density(const Stand& stand, const SpeciesTable& species,
                        std::span<const std::size_t> candidates, double area_ha);

/// The thinnest trees of 7 cm and more, until the relative density is no more than the target (usually
/// 0.5-0.7; matreex 0.65).
Picks thin_to_density(const Stand& stand, const SpeciesTable& species,
                      std::span<const std::size_t> candidates, double area_ha, double target_density);

/// Thinning from above for crop trees [practice; A-value of Johann 1982].
struct CropTreeThinning {
    double crop_trees_pha = 150.0;      ///< > 0, usually 100-200
    std::size_t competitors = 2;        ///< taken at most around each, usually 1-3
    double a_value = 5.0;               ///< > 0: 4 light ... 6 strong
    double most_volume_share = 0.2;     ///< [0, 1], of the candidates' volume
    std::vector<SpeciesId> favoured{};  ///< species that become crop trees before others
};

/// The strongest competitors of crop trees: trees nearer than H / A * d / D of a crop tree of height H and
/// diameter D. Crop trees are those flagged, then favoured species, then the thickest, no two nearer than 0.7
/// of their mean spacing; they are never chosen themselves.
Picks thin_for_crop_trees(const Stand& stand, const SpeciesTable& species,
                          std::span<const std::size_t> candidates, double area_ha,
                          const CropTreeThinning& rule);

/// All trees from a diameter on.
Picks target_diameter(const Stand& stand, std::span<const std::size_t> candidates, double dbh_cm);

/// The diameter distribution of a selection forest: stems fall by the factor q from class to class of 5 cm.
struct SelectionForest {
    double basal_area_m2pha = 28.0;   ///< > 0, that stays; usually 25-32
    double max_dbh_cm = 60.0;         ///< > 12.5; usually 55-65
    double q = 1.3;                   ///< >= 1
    double most_volume_share = 0.25;  ///< [0, 1], of the candidates' volume
};

/// Stems per hectare that a selection forest has in each class of 5 cm from 10 cm on (10-15, 15-20, ...).
std::vector<double> stems_of_selection_forest(const SelectionForest& aim);

/// What a stand has too many of in each class from 10 cm on, thickest class first: within a class the trees
/// of least vitality and light, then by chance.
Picks single_tree_selection(const Stand& stand, const SpeciesTable& species,
                            std::span<const std::size_t> candidates, double area_ha,
                            const SelectionForest& aim, std::uint64_t seed, std::uint32_t replicate);

/// Trees of any size at random, until their share of the basal area is reached: seed cut of a shelterwood,
/// which leaves a loose shelter.
Picks loosen(const Stand& stand, std::span<const std::size_t> candidates, double basal_area_share,
             std::uint64_t seed, std::uint32_t replicate);

}  // namespace forest
