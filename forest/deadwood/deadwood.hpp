#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "forest/climate/series.hpp"
#include "forest/site/site.hpp"
#include "forest/stand/dead_wood.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Trees thinner than this leave no dead wood worth following.
inline constexpr double least_dead_wood_cm = 7.0;
/// A snag or log with less of its density than this has become soil.
inline constexpr double soil_density = 0.1;

/// Height of the stump that felling leaves, as a rule [m].
inline constexpr double stump_height_m = 0.3;

/// What stands of the year's natural deaths: trees of at least 7 cm that died of age, stress, crowding,
/// beetles or wounds become whole snags. Thrown, felled and broken trees are made into dead wood by the
/// processes that fell them.
std::vector<Snag> snags_of_deaths(const Stand& stand);

/// Diameter of a stem of that tree at a height: a cone from the DBH to the tip [cm].
double stem_diameter_cm(double dbh_cm, double tree_height_m, double height_m);

/// Part of the wood of a tree's stem between two heights [0, 1]: that of a cone.
double stem_part(double tree_height_m, double from_m, double to_m);

/// The lying piece of a stem between two heights, thick end at the given place, with its part of the mass.
/// Requires from < to, at most the height of what stands.
Log log_of_piece(const Snag& stem, double from_m, double to_m, double direction_rad);

/// What is left of a stem that gives way.
struct Wreck {
    std::optional<Snag> stump;  ///< nothing if the tree went with its roots
    Log log;
};

/// A tree that breaks at a height, or is uprooted at 0. What lies has its branches yet and rests on them.
/// Requires a height below that of the tree.
Wreck wreck_of(const Tree& tree, double break_m, double direction_rad, LogOrigin origin, int year);

/// Stem wood over bark of dead pieces, as far as decay has left it [m3].
double volume_m3(const Snag& snag, const SpeciesTable& species);
double volume_m3(const Log& log, const SpeciesTable& species);

/// A year of dead wood: this year's dead stand as snags; older ones lose density, break at 1 to 5 m
/// [choice; BAFU] or fall and become logs; logs settle and rot; crosswise logs that have lost their strength
/// may roll out of the slope.
///
/// Falling stems lie down the slope with a scatter of 60 degrees either way [choice]. Chance is drawn by tree
/// and year. Pieces of this year are left as they are. `weather` has one year for each of the site's units.
void age_dead_wood(Stand& stand, const Site& site, const SpeciesTable& species,
                   std::span<const ClimateYear> weather, std::uint64_t seed, std::uint32_t replicate);

}  // namespace forest
