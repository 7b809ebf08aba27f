#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// How often trees of the canopy die of what no process here explains.
struct CanopyDeaths {
    double at_any_age = 0.25;           ///< times 1 / greatest age: probability a year at a warmth of 1
    double larger_m2pha = 50.0;         ///< basal area of thicker trees with which it grows e-fold
    double when_old = 0.0065;           ///< probability a year of an old tree at a crowding and a warmth of 1
    double half_old = 0.35;             ///< share of the greatest age at which half of when_old is reached
    double usual_m2pha = 37.0;          ///< basal area of old forests
    double alone = 0.2;                 ///< share of when_old that remains without neighbours
    double by_density = 4.0;            ///< exponent of basal area / usual_m2pha; 0: no influence
    double most_crowding = 2.5;         ///< most of that power
    double by_size = 0.013;             ///< added at a diameter of 1 m; falls with its sixth power, conifers
    double broadleaves = 3.0;           ///< of it, broadleaves
    double by_warmth = 0.05;            ///< change of all with 100 degree-days (canopy_warmth)
    double usual_degree_days = 1300.0;  ///< where all are as they stand here
    double coldest = 0.6;               ///< least factor of warmth
    double warmest = 1.4;               ///< greatest one
    double beside_storms = 0.9;         ///< share of all where storms are simulated: they contain the rest
};

/// What decides about canopy trees at their place.
struct CanopyPlace {
    double crowding = 1.0;      ///< canopy_crowding(), how many times as often as usual old trees die
    double warmth = 1.0;        ///< canopy_warmth(), the same for trees of any age and size
    double larger_m2pha = 0.0;  ///< basal area of thicker trees around
};

/// Probability of a tree to die within a year [0, 1]:
///
///     w (0.25 / M e^(B / 50 m2/ha) + 0.0065 c x^4 / (1 + x^4) + p1 (D / 1 m)^6) + 8 / A (age / A)^7
///
/// with M the greatest age, x = age / 0.35 M, A = 0.83 M, B the basal area of thicker trees, c the crowding
/// and w the warmth of the place.
///
/// Ordinary stands lose few trees of their canopy: inventories have 0.07 to 0.4 % a year from 30 cm on, up to
/// 2.5 times as many under larger trees (Guyennon et al. 2023), and the longer-lived a species, the fewer
/// die: level and slope were fitted to these (forest_demography). It is an eighteenth of what gap models
/// take at any age. Old forests turn over faster, or they would hold more wood than any (forest_old): level
/// of the rise with age and the age at which half of it is reached were fitted to their wood, thick stems and
/// shares of species; its form is [choice], the fourth power with deaths of forest_demography in view: with
/// the third, dense stands of 100 to 140 years lost two to seven times as many thick trees as inventories.
/// Nothing was chosen by the stems of forest_hauersteig.
/// In unmanaged forests giants die more often (Holzwarth et al. 2013): the sixth power leaves trees below
/// 60 cm alone [choice]. Of age alone one tree in a hundred is alive at the greatest age, as in gap models,
/// and nearly all are at half of it [choice].
double canopy_death(const Species& species, double dbh_cm, double age_years, const CanopyPlace& place,
                    const CanopyDeaths& law, bool storms);

/// How many times as often as usual an old tree dies at its place: 0.2 + (G / 37 m2/ha)^4, the power at most
/// 2.5, with the basal area G around it. Form and level are [choice], such that fully stocked stands that are
/// left alone stop growing on.
double canopy_crowding(double basal_area_m2pha, const CanopyDeaths& law);

/// How many times as often canopy trees die at a warm or cold place: 1 + 0.05 (DD - 1300) / 100 in
/// [0.6, 1.4], DD the usual degree-days above 5.5 degC. Turnover of old conifer forests falls from 1.77 to
/// 0.78 % a year between 1500 and 3000 m in the Sierra Nevada, 2.76 - 0.66 z / km (Stephenson & van Mantgem
/// 2005, Ecology Letters 8:524): by 52 % of its middle a kilometre. With 5.1 K a kilometre (lapse_rates.csv)
/// and, in the climate of forest_belts, 208 degree-days a kelvin that is 4.9 % in 100 degree-days. That
/// deaths follow turnover, and that its middle is as warm as 1300 are [choice]; the bounds are those of 1500
/// and 3000 m.
double canopy_warmth(double usual_degree_days, const CanopyDeaths& law);

/// Trees of more than this diameter may take neighbours with them [choice].
inline constexpr double falls_with_others_cm = 60.0;

/// Share of dying thick trees that fall alive; the others die standing and fall later as snags [choice, near
/// the halves of Holzwarth et al. 2013].
inline constexpr double falls_alive_share = 0.5;

/// The neighbours that thick trees take with them when they fall alive: in a direction that is drawn by the
/// id of the dead tree, the nearest three thinner trees of at least 10 cm that stand within 10 m in a strip
/// as wide as its crown. Together gaps of 100 to 300 m2 open [choice]. `dead` are places in Stand::trees();
/// falls_alive_share of them fall.
std::vector<Removal> taken_along(const Stand& stand, std::span<const std::size_t> dead, std::uint64_t seed,
                                 std::uint32_t replicate);

}  // namespace forest
