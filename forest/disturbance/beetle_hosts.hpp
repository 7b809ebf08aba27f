#pragma once

#include <vector>

#include "forest/stand/species.hpp"
#include "forest/stand/stand.hpp"

namespace forest {

/// Thinner spruces are not attacked.
inline constexpr double least_host_cm = 15.0;

/// Basal area of hosts that feeds a full brood of a patch [m2]: 30 m2/ha [choice].
inline constexpr double full_brood_m2 = 0.3;

/// Whether beetles can live in a tree.
bool is_beetle_host(const Tree& tree, const SpeciesTable& species);

/// Part of hosts in a stand as a factor on the success of beetles [0, 1]:
/// 0.08 + 0.92 / (1 + 0.2675 exp(-6.846 (share - 0.375)))^3.33 (Temperli et al. 2013). `host_share` is of the
/// basal area.
double success_by_share(double host_share);

/// The same for age: 1 / (1 + exp(-0.109 (age - 70))) (Temperli et al. 2013).
double success_by_age(double age_years);

/// The same for stress [0, 1]: 0.15 + 0.85 stress (iLand).
double success_by_stress(double stress);

/// What beetles find on a patch.
struct BeetleHosts {
    double basal_area_m2 = 0.0;  ///< of hosts
    double share = 0.0;          ///< of hosts in the basal area of the patch and the eight around
};

std::vector<BeetleHosts> beetle_hosts_of(const Stand& stand, const SpeciesTable& species);

/// Chance of a host to be killed by a cohort that lands on its patch [0, 1]: the product of the three
/// factors. Stress is the drought of its species on its patch, how far stomata were closed over the season
/// [0, 1], or 1 for a tree that has just had a year of poor growth [choice].
double colonisation_success(const Tree& tree, double drought, const BeetleHosts& around);

}  // namespace forest
