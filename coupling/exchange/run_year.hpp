#pragma once

#include <cstdint>
#include <functional>

#include "coupling/exchange/regimes/apply.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "forest/year.hpp"

namespace coupling::exchange {

/// Rocks of a year through the forest as it stands; an empty result in years without rockfall.
using SimulateRocks = std::function<YearFalls(const forest::Stand& stand, std::int32_t year)>;

/// What the years of one member have in common.
struct MemberSite {
    const ForestSite& forest;
    const forest::SpeciesTable& species;  ///< as the member has them: see ForestFactors
    const forest::Parameters& parameters;
    const Regime& regime;
    std::uint32_t climate = 0;  ///< place among the climates of the site
    forest::YearKey key;        ///< seed and replicate
    SimulateRocks simulate_rocks;
    double real_rock_share = 0.0;  ///< simulated rocks that really fall and wound trees [-]; 0: no feedback
};

/// What changes from year to year.
struct MemberState {
    forest::Stand stand;
    RegimeState regime;
};

/// What happened in a year.
struct YearOutcome {
    forest::YearReport growth;
    double mean_temperature_degc = 0.0;  ///< of the year, mean of the patches
    RegimeReport work;
    YearFalls falls;
};

/// One year of a member: the forest grows, people do what the regime plans, rocks are simulated through what
/// then stands, and the trees that real rocks hit are wounded.
///
/// One list of values goes down (stems_and_logs_of), one comes up (impacts_of). The forest stands still while
/// rocks fall. `year`: simulated years since the start, from 1.
YearOutcome run_year(MemberState& state, const MemberSite& site, std::int32_t year);

/// Year 0: nothing grows; rocks are simulated through the forest of the start and wound it, then people do
/// what the regime plans at once.
YearOutcome run_start(MemberState& state, const MemberSite& site);

}  // namespace coupling::exchange
