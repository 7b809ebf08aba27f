#include "coupling/validation/forest_cases/succession_trial/trial.hpp"

#include <cassert>
#include <utility>

#include "coupling/validation/forest_cases/level_forest.hpp"
#include "forest/tables.hpp"

namespace coupling::validation::forest_cases::succession_trial {

namespace {

using forest::ClimateYear;
using forest::figures_by_species;
using forest::grow_year;
using forest::PatchGrid;
using forest::PatchState;
using forest::Site;
using forest::SpeciesTable;
using forest::Stand;
using forest::StandFigures;
using forest::YearKey;
using forest::YearSequence;

SuccessionState state_of(const Stand& stand, const SpeciesTable& species) {
    SuccessionState state;
    state.year = stand.year();
    for (const StandFigures& figures : figures_by_species(stand.trees(), species, stand.grid().area_ha())) {
        state.species.push_back({.biomass_tpha = figures.above_ground_tpha,
                                 .basal_area_m2pha = figures.basal_area_m2pha,
                                 .stems_pha = figures.stems_pha});
        state.volume_m3pha += figures.volume_m3pha;
    }
    state.ground_light = 0.0;
    for (const PatchState& patch : stand.patch_states()) {
        state.ground_light += patch.ground_light / static_cast<double>(stand.grid().size());
    }
    return state;
}

}  // namespace

double SuccessionState::biomass_tpha() const {
    double sum = 0.0;
    for (const SpeciesShare& one : species) {
        sum += one.biomass_tpha;
    }
    return sum;
}

std::vector<SuccessionState> grow_succession(const SuccessionTrial& trial, const SpeciesTable& species,
                                             const YearKey& key) {
    assert(trial.side_patches > 0 && trial.interval_years > 0);
    PatchGrid grid = level_patches(trial.side_patches, trial.soil);
    const Site site = level_site(grid, trial.latitude, trial.climate.years);
    Stand stand{std::move(grid), species.size(), {}, 0};
    const YearSequence sequence = YearSequence::drawn(trial.window, key.seed, key.replicate);

    std::vector<SuccessionState> states;
    for (int year = 1; year <= trial.years; ++year) {
        const ClimateYear* const climate = trial.climate.find(sequence.source_of(year));
        assert(climate != nullptr);
        const std::vector<ClimateYear> weather(site.units().size(), *climate);
        static_cast<void>(grow_year(stand, site, species, {.units = weather}, trial.parameters, key));
        if (year % trial.interval_years == 0 || year == trial.years) {
            states.push_back(state_of(stand, species));
        }
    }
    return states;
}

}  // namespace coupling::validation::forest_cases::succession_trial
