#include "coupling/validation/forest_cases/yield_trial/trial.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "coupling/validation/forest_cases/level_forest.hpp"
#include "forest/start/places.hpp"
#include "forest/start/starting_stand.hpp"
#include "forest/year.hpp"

namespace coupling::validation::forest_cases::yield_trial {

namespace {

using forest::ClimateYear;
using forest::PatchGrid;
using forest::PatchId;
using forest::Site;
using forest::Species;
using forest::SpeciesTable;
using forest::Stand;
using forest::Tree;

constexpr int hectare_patches = 10;  // along each side
constexpr std::uint32_t replicate = 0;

std::vector<double> first_diameters_cm(const YieldTrial& trial) {
    std::vector<double> diameters_cm(static_cast<std::size_t>(std::lround(trial.stems_pha)));
    for (std::size_t i = 0; i < diameters_cm.size(); ++i) {
        config::RandomStream stream{{trial.seed, replicate, 1, i}, config::Purpose::starting_tree};
        diameters_cm[i] = trial.start_dbh_cm *
                          std::clamp(config::normal(stream.uniform(), 1.0, trial.start_scatter), 0.5, 2.0);
    }
    return diameters_cm;
}

std::vector<Tree> planted_trees(const YieldTrial& trial, const Species& kind, const PatchGrid& grid) {
    const std::vector<double> diameters_cm = first_diameters_cm(trial);
    std::vector<PatchId> patches(grid.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i] = PatchId{static_cast<std::uint32_t>(i)};
    }
    const std::vector<forest::Place> places = forest::places_for(
        grid, patches, diameters_cm, forest::Structure::even_aged, {trial.seed, replicate, 0});
    std::vector<Tree> trees;
    for (std::size_t i = 0; i < diameters_cm.size(); ++i) {
        const double height_m = std::max(1.4, kind.saplings.height_to_diameter * diameters_cm[i] / 100.0);
        trees.push_back(forest::new_tree(kind, trial.species, places[i].x_m, places[i].y_m, diameters_cm[i],
                                         height_m, trial.start_age_years));
        trees.back().id = forest::TreeId{i};
    }
    return trees;
}

}  // namespace

std::vector<TrialState> grow_trial(const YieldTrial& trial, const SpeciesTable& species,
                                   std::span<const int> ages_years) {
    assert(!trial.weather.empty());
    PatchGrid grid = level_patches(hectare_patches, trial.soil);
    const Site site = level_site(grid, trial.latitude, trial.weather);
    std::vector<Tree> trees = planted_trees(trial, species[trial.species], grid);
    Stand stand{std::move(grid), species.size(), std::move(trees), 0};

    std::vector<TrialState> states;
    int age_years = trial.start_age_years;
    for (const int wanted : ages_years) {
        for (; age_years < wanted; ++age_years) {
            const auto past_years = static_cast<std::size_t>(age_years - trial.start_age_years);
            const std::vector<ClimateYear> weather(site.units().size(),
                                                   trial.weather[past_years % trial.weather.size()]);
            static_cast<void>(forest::grow_year(stand, site, species, {.units = weather}, trial.parameters,
                                                {trial.seed, replicate}));
        }
        states.push_back({wanted, forest::figures_of(stand.trees(), species, stand.grid().area_ha())});
    }
    return states;
}

}  // namespace coupling::validation::forest_cases::yield_trial
