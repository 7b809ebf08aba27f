#include "coupling/inputs/forest/spin_up.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "forest/year.hpp"

namespace coupling {
namespace {

/// Moves all chance of the spin-up away from that of the run.
constexpr std::uint64_t other_seed = 0x5350'494E'5550'0001ULL;
/// Numbers of trees that died in the spin-up: above those of the start, below those of given dead wood. The
/// same trees live on at the start.
constexpr std::uint64_t dead_id_offset = (std::uint64_t{1} << 46U) + (std::uint64_t{1} << 45U);

forest::TreeId moved(forest::TreeId tree) {
    return forest::TreeId{forest::number_of(tree) % (std::uint64_t{1} << 45U) + dead_id_offset};
}

}  // namespace

SpunUp spin_up(const ForestSite& site, const forest::Stand& inventoried, std::uint64_t seed,
               std::uint32_t replicate) {
    forest::Stand stand = inventoried;
    const int begin = stand.year();
    const forest::YearKey key{seed ^ other_seed, replicate};
    // Storms, snow and beetles as in the first year of the run: those that begin later have not come yet, and
    // events that are asked for are those of the run alone.
    forest::Parameters parameters = site.parameters;
    parameters.disturbance = parameters.disturbance.in_year(begin + 1);
    parameters.disturbance.first_year = 0;
    parameters.disturbance.storm_years.clear();
    parameters.disturbance.beetle_years.clear();
    ClimateSource climate = site.climates.front().source;
    climate.dry_years.clear();
    std::vector<double> elevations_m;
    for (const forest::SiteUnit& unit : site.place.units()) {
        elevations_m.push_back(unit.elevation_m);
    }
    for (int year = 0; year < site.spin_up_years; ++year) {
        const int calendar_year = begin + 1 + year % std::max(1, site.run_years);
        YearWeather weather = climate.weather(calendar_year, replicate, elevations_m);
        weather.usual_summer_mm = site.climates.front().usual_summer_mm;
        forest::grow_year(stand, site.place, site.species.table, weather.view(), parameters, key);
    }
    SpunUp made{stand.dead_wood(), {stand.cohorts().begin(), stand.cohorts().end()}};
    const int later = stand.year() - begin;
    for (forest::Snag& snag : made.dead_wood.snags) {
        snag.year -= later;
        snag.tree = moved(snag.tree);
    }
    for (forest::Log& log : made.dead_wood.logs) {
        log.year -= later;
        log.tree = moved(log.tree);
    }
    return made;
}

}  // namespace coupling
