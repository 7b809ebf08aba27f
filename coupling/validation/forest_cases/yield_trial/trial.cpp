#include "coupling/validation/forest_cases/yield_trial/trial.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>

#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "forest/growth.hpp"
#include "forest/layer_light.hpp"
#include "forest/light/light.hpp"
#include "forest/production/allocation.hpp"
#include "forest/production/calendar.hpp"
#include "forest/self_thinning.hpp"
#include "forest/stand_light.hpp"
#include "forest/start/places.hpp"
#include "forest/start/starting_stand.hpp"

namespace coupling::validation::forest_cases::yield_trial {

namespace {

using forest::AbsorbedByMonth;
using forest::Canopy;
using forest::compute_light;
using forest::days_in_month;
using forest::Edges;
using forest::Exposure;
using forest::figures_of;
using forest::growth_of_trees;
using forest::index_of;
using forest::layer_light;
using forest::LayerLight;
using forest::light_in_stand;
using forest::light_trees_of;
using forest::light_use_of_year;
using forest::LightGround;
using forest::LightSite;
using forest::LightTree;
using forest::LightYear;
using forest::MonthlyRadiation;
using forest::natural_deaths;
using forest::new_tree;
using forest::Patch;
using forest::patch_side_m;
using forest::PatchGrid;
using forest::PatchId;
using forest::Place;
using forest::places_for;
using forest::root_share;
using forest::self_thinning;
using forest::share_production;
using forest::Sky;
using forest::SkySettings;
using forest::Species;
using forest::SpeciesTable;
using forest::split_radiation;
using forest::Stand;
using forest::StandLight;
using forest::stress_years_after;
using forest::Structure;
using forest::ThinningWindows;
using forest::Tree;
using forest::TreeId;
using forest::TreeProduction;
using forest::TreeSeason;
using forest::YearOfLightUse;

constexpr int hectare_patches = 10;  // along each side
constexpr std::uint32_t replicate = 0;

PatchGrid level_hectare(const YieldTrial& trial) {
    const config::GridFrame frame{.columns = hectare_patches,
                                  .rows = hectare_patches,
                                  .cell_width_m = patch_side_m,
                                  .cell_height_m = patch_side_m};
    std::vector<Patch> patches(frame.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i].cell = frame.cell_of(i);
        patches[i].soil.fertility = trial.fertility;
        patches[i].soil.ph = trial.ph;
    }
    return {frame, patches};
}

Stand plantation(const YieldTrial& trial, const SpeciesTable& species) {
    PatchGrid grid = level_hectare(trial);
    const Species& kind = species[trial.species];
    std::vector<double> diameters(static_cast<std::size_t>(std::lround(trial.stems_pha)));
    for (std::size_t i = 0; i < diameters.size(); ++i) {
        config::RandomStream stream{{trial.seed, replicate, 1, i}, config::Purpose::starting_tree};
        diameters[i] = trial.start_dbh_cm *
                       std::clamp(config::normal(stream.uniform(), 1.0, trial.start_scatter), 0.5, 2.0);
    }
    std::vector<PatchId> patches(grid.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        patches[i] = PatchId{static_cast<std::uint32_t>(i)};
    }
    const std::vector<Place> places =
        places_for(grid, patches, diameters, Structure::even_aged, {trial.seed, replicate, 0});
    std::vector<Tree> trees;
    for (std::size_t i = 0; i < diameters.size(); ++i) {
        const double height_m = std::max(1.4, kind.saplings.height_to_diameter * diameters[i] / 100.0);
        trees.push_back(new_tree(kind, trial.species, places[i].x_m, places[i].y_m, diameters[i], height_m,
                                 trial.start_age_years));
        trees.back().id = TreeId{i};
    }
    return {std::move(grid), species.size(), std::move(trees), 0};
}

/// A year's light in the stand.
using Shine = std::function<StandLight(const Stand&, const TrialYear&)>;

Shine shine_by_layers(const SpeciesTable& species) {
    return [&species](const Stand& stand, const TrialYear& weather) {
        const std::span<const Tree> trees = stand.trees();
        StandLight light;
        const std::vector<LayerLight> by_layers = layer_light(trees, species, stand.grid().area_m2());
        for (std::size_t i = 0; i < trees.size(); ++i) {
            light.ratios.push_back(by_layers[i].light_ratio);
            light.shaded_below_m.push_back(by_layers[i].shaded_below_m);
            AbsorbedByMonth& absorbed = light.absorbed.emplace_back();
            for (std::size_t m = 0; m < absorbed.size(); ++m) {
                const bool in_leaf = species[trees[i].species].light.in_leaf(static_cast<int>(m) + 1);
                const double area_m2 = in_leaf ? trees[i].stems * by_layers[i].absorbed_m2 : 0.0;
                absorbed[m] = area_m2 * weather.radiation_mjpm2[m];
            }
        }
        return light;
    };
}

MonthlyRadiation split_of(const YieldTrial& trial, const TrialYear& weather) {
    std::array<double, 12> daily_mjpm2{};
    for (std::size_t m = 0; m < daily_mjpm2.size(); ++m) {
        daily_mjpm2[m] = weather.radiation_mjpm2[m] / days_in_month(static_cast<int>(m) + 1);
    }
    return split_radiation(trial.latitude, daily_mjpm2);
}

Shine shine_in_space(const YieldTrial& trial, const SpeciesTable& species, const PatchGrid& grid) {
    SkySettings settings;
    settings.latitude = trial.latitude;
    const Sky sky{settings, split_of(trial, trial.weather.front())};
    const LightGround ground{.elevation_m = config::Raster<double>{grid.frame()}, .edges = Edges::torus};
    const std::vector<Exposure> level(1);
    const LightSite site{sky, ground, level};
    return [&trial, &species, site](const Stand& stand, const TrialYear& weather) {
        LightYear year{.radiation = split_of(trial, weather)};
        for (std::size_t m = 0; m < year.leaves_on.size(); ++m) {
            year.leaves_on[m] = species[trial.species].light.in_leaf(static_cast<int>(m) + 1);
        }
        const std::vector<LightTree> trees = light_trees_of(stand, species);
        const Canopy canopy{site.ground(), trees};
        return light_in_stand(stand, species, site, canopy, compute_light(site, canopy, year, trees));
    };
}

/// What the trees have to grow with.
std::vector<TreeSeason> seasons_of(const Stand& stand, const YieldTrial& trial, const TrialYear& weather,
                                   const StandLight& light, const SpeciesTable& species) {
    const std::span<const Tree> trees = stand.trees();
    const Species& kind = species[trial.species];
    const std::vector<std::uint32_t> one_unit(trees.size(), 0);
    std::vector<YearOfLightUse> light_use(species.size());
    light_use[index_of(trial.species)] = light_use_of_year(kind, weather.months, trial.fertility, trial.ph);
    const std::vector<TreeProduction> production =
        share_production(trees, species, light.absorbed, one_unit, light_use);
    std::vector<TreeSeason> seasons(trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) {
        seasons[i] = {
            .npp_kg = production[i].npp_kg,
            .root_share = root_share(kind.three_pg.root_share, production[i].physiology, trial.fertility),
            .degree_days = weather.degree_days,
            .shaded_below_m = light.shaded_below_m[i]};
    }
    return seasons;
}

void let_die(Stand& stand, const YieldTrial& trial, const SpeciesTable& species,
             const ThinningWindows& windows) {
    const std::vector<std::uint32_t> one_unit(stand.trees().size(), 0);
    stand.set_stress_years(stress_years_after(stand, trial.mortality, one_unit, 1));
    stand.remove_trees(natural_deaths(stand, species, trial.mortality, trial.seed, replicate));
    stand.remove_trees(self_thinning(stand, species, windows, trial.seed, replicate));
}

}  // namespace

std::vector<TrialState> grow_trial(const YieldTrial& trial, TrialLight light, const SpeciesTable& species,
                                   std::span<const int> ages_years) {
    assert(!trial.weather.empty());
    Stand stand = plantation(trial, species);
    const Shine shine =
        light == TrialLight::layers ? shine_by_layers(species) : shine_in_space(trial, species, stand.grid());
    const ThinningWindows windows{stand.grid()};
    std::vector<TrialState> states;
    int age_years = trial.start_age_years;
    for (const int wanted : ages_years) {
        for (; age_years < wanted; ++age_years) {
            const TrialYear& weather =
                trial.weather[static_cast<std::size_t>(age_years - trial.start_age_years) %
                              trial.weather.size()];
            stand.begin_year();
            const StandLight of_year = shine(stand, weather);
            stand.set_light_ratios(of_year.ratios);
            stand.grow(growth_of_trees(stand, species, seasons_of(stand, trial, weather, of_year, species)));
            let_die(stand, trial, species, windows);
        }
        states.push_back({wanted, figures_of(stand.trees(), species, stand.grid().area_ha())});
    }
    return states;
}

}  // namespace coupling::validation::forest_cases::yield_trial
