#pragma once

#include <cstdint>
#include <optional>

#include "config/random/stream.hpp"
#include "forest/stand/cohort.hpp"
#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Height of a seedling that has established [m] [choice].
inline constexpr double seedling_height_m = 0.05;
/// Saplings of this height become trees of 1 cm diameter [m] [choice].
inline constexpr double recruitment_height_m = 2.0;

/// Height after a year without limits (iLand): Hx (1 - (1 - (h / Hx)^(1/3)) exp(-r))^3.
double potential_height_m(const Saplings& species, double height_m);

/// What a place offers to young trees in a year.
struct SaplingPlace {
    double environment = 1.0;   ///< [0, 1], warmth and the cube root of nitrogen times soil water
    double ground_light = 1.0;  ///< [0, 1]
    double deer = 0.0;          ///< browsing pressure: 0 fenced, 1 normal, 3 high
    bool snow_glides = false;   ///< steep, open, snowy and smooth: snow tears young trees out
};

/// Chance that deer browse a cohort within a year: p at pressure 1, with odds that rise with the pressure to
/// the power 1.81. p is the share of young trees whose leading shoot is browsed in a year, as the Swiss
/// inventory finds it, where it gives one for the species: a fir is browsed in one of four years, an oak in
/// one of three, a spruce in one of fifty. The power gives fir the chance of iLand, 0.71, at a high pressure
/// of 3 [choice].
double browsing_chance(const Saplings& species, double pressure);

/// The pressure at which deer browse a cohort with this chance [0, 1) within a year: the inverse of
/// browsing_chance. Nothing for a species that deer leave alone.
std::optional<double> pressure_of_browsing(const Saplings& species, double chance);

/// Share of the stems of a cohort that deer reach [0, 1]: those from 0.1 to 1.3 m. Heights lie evenly within
/// 40 % of the mean, so that the tallest escape first [choice].
double share_in_reach(double mean_height_m);

/// Whether deer reach the leading shoots of a cohort of this mean height: 0.1 to 1.3 m.
bool is_in_reach(double mean_height_m);

/// What a year does to a cohort.
struct SaplingYear {
    CohortGrowth growth;
    std::uint32_t browsed = 0;     ///< stems that die of it
    std::uint32_t stressed = 0;    ///< that die of years without growth: all or none
    std::uint32_t torn_out = 0;    ///< by gliding snow
    std::uint32_t background = 0;  ///< of all else
};

/// Growth and deaths of a cohort.
///
/// It grows by the potential times environment and light response. Deer find the cohort of a year or do not;
/// if they do, all stems in their reach are browsed. Browsed stems do not grow, and a third of those above
/// 0.3 m lose 10 cm [choice]; the cohort's height is the mean. A year with less than the species'
/// least growth share is one of stress; one more of them in a row than it stands, and the cohort dies.
/// Deaths a year: 25 % of seedlings in their first seven years (Kupferschmid et al. 2002, spruce) until they
/// are 0.5 m tall; of others [choice] 3 % below 0.5 m, 1.5 % above; browsing 10 % of the browsed stems of
/// species that suffer much, else 3 %; gliding snow 5 %; planted ones 10.6 % more in their first two years.
/// Parts of a stem and the visit of deer are decided by `chance`, one number a cause.
SaplingYear year_of_cohort(const Species& species, const Cohort& cohort, const SaplingPlace& place,
                           const config::FourUniforms& chance);

/// Share of a patch's room that one stem takes [-]: 1 / most stems of its height, 10 000 h^-1.2 a hectare,
/// h at least 0.5 m [choice].
double room_of_stem(double height_m);

}  // namespace forest
