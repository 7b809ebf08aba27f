#include "validation/engine/forest_cases/succession_trial/trial.hpp"

#include <cassert>
#include <optional>
#include <utility>

#include "forest/inventory/tables.hpp"
#include "forest/stand/allometry.hpp"
#include "validation/engine/forest_cases/shared/level_forest.hpp"

namespace coupling::validation::forest_cases::succession_trial {

namespace {

using forest::ClimateYear;
using forest::grow_year;
using forest::PatchGrid;
using forest::PatchState;
using forest::Site;
using forest::SpeciesTable;
using forest::Stand;
using forest::StandFigures;
using forest::YearKey;
using forest::YearSequence;

using LostByCause = std::array<double, forest::cause_count>;
using DeathsBySize = std::array<Deaths, death_class_from_cm.size()>;

/// The class of a diameter; none for trees below the first.
std::optional<std::size_t> death_class_of(double dbh_cm) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < death_class_from_cm.size(); ++i) {
        if (dbh_cm >= death_class_from_cm[i]) {
            found = i;
        }
    }
    return found;
}

void count_year(const Stand& stand, DeathsBySize& sizes) {
    for (const forest::Tree& tree : stand.trees()) {
        if (const auto size = death_class_of(tree.dbh_cm)) {
            sizes[*size].tree_years += tree.stems;
        }
    }
    for (const forest::DeadTree& dead : stand.deaths()) {
        if (const auto size = death_class_of(dead.tree.dbh_cm)) {
            sizes[*size].tree_years += dead.tree.stems;
            sizes[*size].deaths += dead.tree.stems;
        }
    }
}

void count_losses(const Stand& stand, const SpeciesTable& species, LostByCause& lost_m3pha) {
    for (const forest::DeadTree& dead : stand.deaths()) {
        lost_m3pha[forest::index_of(dead.cause)] +=
            dead.tree.stems / stand.grid().area_ha() *
            forest::stem_volume_m3(species[dead.tree.species].allometry, dead.tree.dbh_cm,
                                   dead.tree.height_m);
    }
}

double mean_drought_index(const Stand& stand) {
    double sum = 0.0;
    for (const PatchState& patch : stand.patch_states()) {
        sum += patch.drought_index;
    }
    return sum / static_cast<double>(stand.grid().size());
}

SuccessionState state_of(const Stand& stand, const SpeciesTable& species) {
    constexpr double thick_cm = 60.0;
    constexpr double counted_cm = 10.0;
    SuccessionState state;
    state.year = stand.year();
    const forest::StandYear year = forest::year_of(stand, species, 0.0);
    state.top_height_m = year.all.dominant_height_m;
    state.dead_wood_m3pha = year.snags_m3pha + year.logs_m3pha;
    state.dead_wood_by_class_m3pha = year.dead_wood_m3pha;
    for (const forest::Tree& tree : stand.trees()) {
        state.thick_stems_pha += tree.dbh_cm > thick_cm ? tree.stems / stand.grid().area_ha() : 0.0;
    }
    for (const StandFigures& figures : year.by_species) {
        state.species.push_back({.biomass_tpha = figures.above_ground_tpha,
                                 .basal_area_m2pha = figures.basal_area_m2pha,
                                 .stems_pha = figures.stems_pha});
        state.volume_m3pha += figures.volume_m3pha;
    }
    for (const forest::Tree& tree : stand.trees()) {
        state.species[forest::index_of(tree.species)].stems_10cm_pha +=
            tree.dbh_cm >= counted_cm ? tree.stems / stand.grid().area_ha() : 0.0;
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

double SuccessionState::basal_area_m2pha() const {
    double sum = 0.0;
    for (const SpeciesShare& one : species) {
        sum += one.basal_area_m2pha;
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
    DeathsBySize deaths{};
    LostByCause lost_m3pha{};
    int years_counted = 0;
    forest::Parameters undisturbed = trial.parameters;
    undisturbed.disturbance.wind = undisturbed.disturbance.snow = undisturbed.disturbance.beetle = false;
    double drought = 0.0;
    for (int year = 1; year <= trial.years; ++year) {
        const ClimateYear* const climate = trial.climate.find(sequence.source_of(year));
        assert(climate != nullptr);
        const std::vector<ClimateYear> weather(site.units().size(), *climate);
        static_cast<void>(grow_year(stand, site, species, {.units = weather},
                                    year < trial.disturbed_from_year ? undisturbed : trial.parameters, key));
        count_year(stand, deaths);
        count_losses(stand, species, lost_m3pha);
        ++years_counted;
        drought += mean_drought_index(stand);
        if (year % trial.interval_years == 0 || year == trial.years) {
            states.push_back(state_of(stand, species));
            states.back().deaths = deaths;
            states.back().drought_index = drought / years_counted;
            deaths = {};
            for (std::size_t cause = 0; cause < lost_m3pha.size(); ++cause) {
                states.back().lost_m3pha[cause] = lost_m3pha[cause] / years_counted;
            }
            lost_m3pha = {};
            years_counted = 0;
            drought = 0.0;
        }
    }
    return states;
}

}  // namespace coupling::validation::forest_cases::succession_trial
