#include "coupling/exchange/run_year.hpp"

namespace coupling::exchange {
namespace {

double mean_temperature_degc(const forest::Site& site, const YearWeather& weather) {
    double sum = 0.0;
    double patches = 0.0;
    for (std::size_t u = 0; u < site.units().size(); ++u) {
        const auto count = static_cast<double>(site.units()[u].patches.size());
        for (const forest::ClimateMonth& month : weather.units[u].months) {
            sum += count * month.tave_degc / 12.0;
        }
        patches += count;
    }
    return sum / patches;
}

void grow(MemberState& state, const MemberSite& site, YearOutcome& outcome) {
    const ForestSite& forest = site.forest;
    const YearWeather weather = forest.weather(site.climate, state.stand.year() + 1, site.key.replicate);
    outcome.growth =
        forest::grow_year(state.stand, forest.place, site.species, weather.view(), site.parameters, site.key);
    outcome.mean_temperature_degc = mean_temperature_degc(forest.place, weather);
}

RegimeReport manage(MemberState& state, const MemberSite& site, std::int32_t year) {
    return apply(site.regime, year, state.stand, site.species, state.regime, site.key);
}

void wound_trees(MemberState& state, const MemberSite& site, const YearFalls& falls, std::int32_t year) {
    if (site.real_rock_share <= 0.0 || falls.hits.empty()) {
        return;
    }
    const std::vector<forest::Impact> impacts =
        impacts_of(falls.hits, {site.real_rock_share, site.key.seed, site.key.replicate, year});
    forest::wound(state.stand, site.species, impacts, site.parameters.uprooting, site.key.seed,
                  site.key.replicate);
}

}  // namespace

YearOutcome run_year(MemberState& state, const MemberSite& site, std::int32_t year) {
    YearOutcome outcome;
    grow(state, site, outcome);
    outcome.work = manage(state, site, year);
    outcome.falls = site.simulate_rocks(state.stand, year);
    wound_trees(state, site, outcome.falls, year);
    return outcome;
}

YearOutcome run_start(MemberState& state, const MemberSite& site) {
    YearOutcome outcome;
    outcome.falls = site.simulate_rocks(state.stand, 0);
    wound_trees(state, site, outcome.falls, 0);
    outcome.work = manage(state, site, 0);
    return outcome;
}

}  // namespace coupling::exchange
