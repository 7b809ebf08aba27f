#pragma once

#include <span>
#include <vector>

#include "forest/light/light.hpp"
#include "forest/production/unit_production.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// What a year's light means for the trees of a stand, one entry a tree record.
struct StandLight {
    std::vector<double> ratios;             ///< [0, 1], without the tree's own shade
    std::vector<AbsorbedByMonth> absorbed;  ///< all stems of the record together
    std::vector<double>
        shaded_below_m;  ///< height below which its species gets too little light; 0 = nowhere
};

/// The trees as light sees them. The stems of a group stand on one spot.
std::vector<LightTree> light_trees_of(const Stand& stand, const SpeciesTable& species);

/// Light of a year in a stand, from the field that its trees made. The columns of the site are the cells of
/// the stand's frame, `canopy` and `field` are of light_trees_of(stand).
///
/// Trees of one cell differ by where their crowns are within it (forest/light/light_profile.hpp). The stems
/// of a group shade each other: only the shade of a single stem is its own.
StandLight light_in_stand(const Stand& stand, const SpeciesTable& species, const LightSite& site,
                          const Canopy& canopy, const LightField& field);

/// The same without places: light by layers (forest/light/layer_light.hpp) under the `radiation` of level
/// ground [MJ/m2, sums of months]. A frame of reference for light_in_stand().
StandLight light_by_layers(const Stand& stand, const SpeciesTable& species,
                           const MonthlyRadiation& radiation);

}  // namespace forest
