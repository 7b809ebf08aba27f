#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// How often trees of the canopy die of what no process here explains.
struct CanopyDeaths {
    double at_any_size = 0.0013;        ///< probability a year among usual_larger_m2pha of larger trees
    double by_rank = 0.018;             ///< change of its logarithm with each m2/ha of larger trees
    double usual_larger_m2pha = 20.0;   ///< where at_any_size holds
    double of_old = 0.0055;             ///< added to it for old trees, at a crowding and a warmth of 1
    double old_from = 0.15;             ///< share of the greatest age at which that begins
    double old_at = 0.28;               ///< share of it from which on that is added in full
    double usual_m2pha = 37.0;          ///< basal area of old forests
    double alone = 0.2;                 ///< share of of_old that remains without neighbours
    double by_density = 4.0;            ///< exponent of basal area / usual_m2pha; 0: no influence
    double most_crowding = 2.5;         ///< most of that power
    double by_size = 0.014;             ///< added at a diameter of 1 m; falls with its sixth power, conifers
    double broadleaves = 3.0;           ///< of it, broadleaves
    double by_warmth = 0.05;            ///< change of both with 100 degree-days (canopy_warmth)
    double usual_degree_days = 1300.0;  ///< where both are as they stand here
    double coldest = 0.6;               ///< least factor of warmth
    double warmest = 1.4;               ///< greatest one
};

/// What decides on deaths in the canopy at the place of a tree.
struct CanopyPlace {
    double larger_m2pha = 20.0;  ///< basal area of larger trees, deaths at any size
    double crowding = 1.0;       ///< canopy_crowding(), deaths of old trees
    double warmth = 1.0;         ///< canopy_warmth(), deaths of old trees and of giants
};

/// Probability of a tree to die within a year [0, 1]:
/// p0 e^(b (L - 20 m2/ha)) + w (c p1 o + p2 (D / 1 m)^6) + 8 / A (age / A)^7.
/// L is the basal area of larger trees, o how old the tree is (0 up to `old_from` of the greatest age, 1 from
/// `old_at` on), c the crowding and w the warmth of its place, A 0.83 of the greatest age.
///
/// The first term is what inventories without disturbance show of trees from 30 cm on (Guyennon et al. 2023):
/// 0.1 to 0.4 % a year, more among larger trees, and no rise with diameter. Old forests cannot be that
/// long-lived: in them deaths are as many as gap models have, 0.5 to 1 % a year and more where they are dense.
/// So old trees have a term of their own [choice]. In unmanaged forests giants die more often (Holzwarth et
/// al. 2013): the sixth power leaves trees below 60 cm alone [choice]. Of age alone one tree in a hundred is
/// alive at the greatest age, as in gap models, and nearly all are at half of it [choice].
double canopy_death(const Species& species, double dbh_cm, double age_years, const CanopyPlace& place,
                    const CanopyDeaths& law);

/// How many times as often as `at_any_size` a tree dies among larger ones: e^(0.018 (L - 20)), L in m2/ha.
/// Inventories have 0.021 for fir, 0.008 for beech, 0.019 for larch and 0.027 for spruce at their optimum;
/// one value for all is [choice].
double canopy_rank(double larger_m2pha, const CanopyDeaths& law);

/// How many times as often as `of_old` an old tree dies at its place: 0.2 + (G / 37 m2/ha)^4, the power at
/// most 2.5, with the basal area G around it. Inventories see deaths rise with basal area, and some without
/// any (Guyennon et al. 2023); form and level are [choice], such that old forests that are left alone stop
/// growing on.
double canopy_crowding(double basal_area_m2pha, const CanopyDeaths& law);

/// How many times as often old trees and giants die at a warm or cold place: 1 + 0.05 (DD - 1300) / 100 in
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
