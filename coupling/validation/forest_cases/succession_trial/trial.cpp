#include "coupling/validation/forest_cases/succession_trial/trial.hpp"

#include <array>
#include <cassert>
#include <utility>

#include "forest/tables.hpp"

namespace coupling::validation::forest_cases::succession_trial {

namespace {

using forest::AgeLaw;
using forest::ClimateYear;
using forest::Edges;
using forest::figures_by_species;
using forest::grow_year;
using forest::Horizon;
using forest::LightGround;
using forest::MonthlyRadiation;
using forest::Parameters;
using forest::Patch;
using forest::patch_side_m;
using forest::PatchGrid;
using forest::PatchState;
using forest::Site;
using forest::Sky;
using forest::SkySettings;
using forest::SpeciesTable;
using forest::split_radiation;
using forest::Stand;
using forest::StandFigures;
using forest::YearKey;
using forest::YearSequence;

PatchGrid level_ground(const SuccessionTrial& trial) {
    const config::GridFrame frame{.columns = trial.side_patches,
                                  .rows = trial.side_patches,
                                  .cell_width_m = patch_side_m,
                                  .cell_height_m = patch_side_m};
    std::vector<Patch> patches(frame.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].cell = frame.cell_of(i);
        patches[i].soil = trial.soil;
    }
    return {frame, patches};
}

/// Mean radiation of the series, which shapes the sky.
MonthlyRadiation radiation_of(const SuccessionTrial& trial) {
    std::array<double, 12> daily_mjpm2{};
    for (const ClimateYear& year : trial.climate.years) {
        for (std::size_t m = 0; m < daily_mjpm2.size(); ++m) {
            daily_mjpm2[m] +=
                year.months[m].radiation_mjpm2 / static_cast<double>(trial.climate.years.size());
        }
    }
    return split_radiation(trial.latitude, daily_mjpm2);
}

Site site_of(const SuccessionTrial& trial, const PatchGrid& grid) {
    SkySettings settings;
    settings.latitude = trial.latitude;
    const LightGround ground{.elevation_m = config::Raster<double>{grid.frame()}, .edges = Edges::torus};
    return {grid, trial.latitude, {Sky{settings, radiation_of(trial)}, ground, {Horizon{}}}};
}

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

Parameters potential_vegetation() {
    Parameters parameters;
    parameters.mortality.age = AgeLaw::gap_model;
    parameters.regeneration.browsing_pressure = 0.0;
    return parameters;
}

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
    PatchGrid grid = level_ground(trial);
    const Site site = site_of(trial, grid);
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
