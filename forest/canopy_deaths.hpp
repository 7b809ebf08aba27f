#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "forest/species.hpp"
#include "forest/stand.hpp"

namespace forest {

/// How often trees of the canopy die of what no process here explains.
struct CanopyDeaths {
    double at_any_size = 0.0025;  ///< probability a year where basal area is `usual_m2pha`
    double usual_m2pha = 40.0;    ///< basal area of old forests
    double by_density = 4.0;      ///< exponent of basal area / usual_m2pha; 0: no influence
    double most_crowding = 4.0;   ///< most of that power
    double by_size = 0.04;        ///< added at a diameter of 1 m; falls with its sixth power, conifers
    double broadleaves = 1.5;     ///< of it, broadleaves
    double beside_storms = 0.5;   ///< share of both where storms are simulated: they contain the rest
};

/// Probability of a tree to die within a year [0, 1]: c p0 + p1 (D / 1 m)^6 + 4 / A (age / A)^3, A three
/// quarters of the greatest age, c the crowding of its place (canopy_crowding). Gap models have 0.5 to 1 % a
/// year at any size. Inventories show no rise up to 50 cm (Guyennon et al. 2023); in unmanaged forests giants
/// die more often (Holzwarth et al. 2013): the sixth power leaves trees below 60 cm alone [choice].
double canopy_death(const Species& species, double dbh_cm, double age_years, double crowding,
                    const CanopyDeaths& law, bool storms);

/// How many times as often canopy trees die at a basal area around them as at that of old forests:
/// (G / 40 m2/ha)^4, at most 4. Inventories see deaths rise with basal area (Guyennon et al. 2023); form and
/// level are [choice], such that fully stocked stands that are left alone stop growing on at 50 m2/ha.
double canopy_crowding(double basal_area_m2pha, const CanopyDeaths& law);

/// Trees of more than this diameter may take neighbours with them [choice].
inline constexpr double falls_with_others_cm = 60.0;

/// The neighbours that thick trees take with them when they fall: in a direction that is drawn by the id of
/// the fallen tree, the nearest three thinner trees of at least 10 cm that stand within 10 m in a strip as
/// wide as its crown. Together gaps of 100 to 300 m2 open [choice]. `fallen` are places in Stand::trees().
std::vector<Removal> taken_along(const Stand& stand, std::span<const std::size_t> fallen, std::uint64_t seed,
                                 std::uint32_t replicate);

}  // namespace forest
