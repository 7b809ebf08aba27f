#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// One hit of a tree by a rock.
struct Impact {
    TreeId tree{};
    double height_m = 0.0;         ///< of the hit above the ground, >= 0
    double energy_share = 0.0;     ///< energy of the hit / what a sound stem takes [-], >= 0
    bool frontal = false;          ///< the rock met the middle of the stem
    double rock_diameter_m = 0.0;  ///< > 0
    double direction_rad = 0.0;    ///< of the rock on the map, counter-clockwise from east
};

/// How a tree that a rock overcomes gives way [choice].
struct UprootingLaw {
    double deep_soil = 0.2;     ///< [0, 1], chance to be uprooted instead of broken
    double shallow_soil = 0.4;  ///< [0, 1]
    double shallow_mm = 70.0;   ///< water capacity up to which a soil is shallow
};

/// What hits did.
struct WoundReport {
    std::uint64_t broken = 0;    ///< stems
    std::uint64_t uprooted = 0;  ///< stems
    std::uint64_t wounded = 0;   ///< hits that left a scar
    std::uint64_t missed = 0;    ///< hits of trees that did not stand (any more)
};

/// Energy that a stem takes at a height relative to a sound one: 1 - (rot / radius)^3, at least 0.2 [choice];
/// 1 where there is no rot.
double stem_strength(const Tree& tree, double height_m);

/// Applies hits of rocks to trees, in the order of the list.
///
/// A frontal hit of more than the stem takes breaks it where it was hit, at 3 m at most, or uproots it: the
/// stand gets a stump and a log, or a log. Any other hit leaves a wound of width min(rock, DBH) (0.3 + 0.5
/// q), q at most 1, 1.5 times as high, an ellipse [choice; field studies find 100-400 cm2]. Wounds closer
/// than 30 cm become one. Vitality falls by 0.6 of the share of the circumference. Deep wounds, of q above
/// 0.2 [choice], may let rot in.
///
/// Of a group of young trees a hit takes one stem or nothing. Chance is drawn by tree and year, hits of a
/// tree in their order; a second call in a year begins with the same numbers.
WoundReport wound(Stand& stand, const SpeciesTable& species, std::span<const Impact> impacts,
                  const UprootingLaw& law, std::uint64_t seed, std::uint32_t replicate);

/// Chance that a tree dies of its wounds within a year: 0.03 * open share of the circumference + 0.02 * the
/// largest energy share, half of it for broadleaves [choice; Vospernik 2002 finds more deaths of wounded
/// spruce].
double wound_death(const Species& species, double dbh_cm, std::span<const Wound> wounds);

/// Deaths by wounds in the current year.
std::vector<Removal> wound_deaths(const Stand& stand, const SpeciesTable& species, std::uint64_t seed,
                                  std::uint32_t replicate);

/// A year of healing and rot: wounds close by 1 cm from each side where the light ratio is above 0.3,
/// vitality comes back by 0.02, rot spreads along the stem by the species' rate and by 0.3 cm towards the
/// bark [choice].
void heal(Stand& stand, const SpeciesTable& species);

}  // namespace forest
