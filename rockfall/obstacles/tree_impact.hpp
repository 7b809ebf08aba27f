#pragma once

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "rockfall/obstacles/stem_index.hpp"
#include "rockfall/obstacles/tree_deviation.hpp"

namespace rockfall {

/// What happens at a stem beside its strength.
struct TreeImpactLaw {
    double frontal_limit = 0.40;   ///< hits more central than this are frontal [-]
    double scratch_limit = 0.746;  ///< hits further out scratch: the sigmoid is zero there [-]
    bool taper = true;             ///< stem radius by height of the hit; off: DBH everywhere
    bool height_effect = true;     ///< a hit above breast height meets the thinner stem there
    bool remove_broken = false;    ///< a broken tree or log is no longer in the way of the rocks that follow
    double stop_share = 0.02;      ///< a rock left with less of its energy stays at the tree [-]
    double energy_factor = 1.0;    ///< on what every stem takes [-]
    DeviationMatrix deviation;
};

HitType hit_type(double relative_position, const TreeImpactLaw& law);

/// What a hit does to rock and tree.
struct TreeImpact {
    HitType type;
    double loss_j;        ///< energy taken by the tree
    double speed_factor;  ///< speed and spin after the hit divided by those before [-]
    config::SinCos turn;  ///< deviation in plan, counter-clockwise
    bool broken;
    bool stopped;
};

/// The hit of a rock of kinetic energy `energy_j` (translation and rotation) on a stem.
///
/// The tree takes what its position and height on the stem allow; a frontal hit beyond the stem's strength
/// breaks it (Rammer et al. 2010). The path turns away from the axis, as tree_deviation.hpp says. `draws`:
/// class, angle within it, side of an exactly central hit.
TreeImpact meet_stem(double energy_j, const StemHit& hit, const PlacedStem& stem, const TreeImpactLaw& law,
                     const config::FourUniforms& draws);

}  // namespace rockfall
